// Tables as spreadsheets write them, and as they should not.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "exercises/cli/csv_reader.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

using Cells = std::vector<std::string>;

CsvTable table_of(const std::string& bytes) { return read_csv(bytes, "t.csv"); }

void refused_table(const std::string& bytes, const std::string& why) {
  CAPTURE(bytes.substr(0, 200));
  CHECK_THROWS_WITH(table_of(bytes), why);
}

}  // namespace

TEST_CASE("a table by RFC 4180") {
  const CsvTable table =
      table_of("number,name\r\n1,\"Rossi, Anna\"\r\n2,\"say \"\"due\"\"\"\r\n3,\"two\r\nlines\"\r\n4,\r\n");
  CHECK(table.header == Cells{"number", "name"});
  REQUIRE(table.rows.size() == 4);
  CHECK(table.rows[0].cells == Cells{"1", "Rossi, Anna"});
  CHECK(table.rows[1].cells == Cells{"2", "say \"due\""});
  CHECK(table.rows[2].cells == Cells{"3", "two\r\nlines"});
  CHECK(table.rows[3].cells == Cells{"4", ""});
  CHECK(table.rows[3].line == 6);  // the third row took two lines
}

TEST_CASE("what divides fields is read off the header") {
  CHECK(table_of("\xEF\xBB\xBFnumber;v_B\n1;5,25\n").rows[0].cells == Cells{"1", "5,25"});
  CHECK(table_of("\xEF\xBB\xBFnumber;v_B\n").header == Cells{"number", "v_B"});
  CHECK(table_of("number\tv_B\n1\t5,25").rows[0].cells == Cells{"1", "5,25"});
  CHECK(table_of("number,v_B\n1,\"5,25\"\n").rows[0].cells == Cells{"1", "5,25"});
  CHECK(table_of("\"a;b;c\",d\n1,2\n").header == Cells{"a;b;c", "d"});
  CHECK(table_of("number\n1\n2\n").rows.size() == 2);
  CHECK(table_of("number;l,max;l,min\n1;1,9;1,2\n").rows[0].cells == Cells{"1", "1,9", "1,2"});
  CHECK(table_of("Matricola;Cognome, Nome\n1;Rossi, Anna\n").header == Cells{"Matricola", "Cognome, Nome"});
  CHECK(table_of("\r\n \nnumber;name\n1;Anna\n").header == Cells{"number", "name"});
  CHECK(table_of("sep=;\r\nnumber;l,max,m,n\r\n1;2\r\n").header == Cells{"number", "l,max,m,n"});
  CHECK(table_of("sep=;\nnumber;v_B\n1;5,25\n").rows[0].line == 3);
  CHECK(table_of("sep=;x\na;b\n").header == Cells{"sep=", "x"});
  CHECK(table_of("number,v_B\r1,2\r3,4").rows[1].cells == Cells{"3", "4"});
}

TEST_CASE("blanks around fields, blank lines, and quotes inside of a field") {
  const CsvTable table = table_of("\n number , name \n\n1 , Anna \"Nina\" Rossi\n,\n  \" kept \",x\n");
  CHECK(table.header == Cells{"number", "name"});
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].cells == Cells{"1", "Anna \"Nina\" Rossi"});
  CHECK(table.rows[0].line == 4);
  CHECK(table.rows[1].cells == Cells{"\" kept \"", "x"});
}

TEST_CASE("columns that a spreadsheet adds without name and content are left out") {
  const CsvTable table = table_of("number;;v_B;;\n1;;5,25;;\n");
  CHECK(table.header == Cells{"number", "v_B"});
  CHECK(table.rows[0].cells == Cells{"1", "5,25"});
  refused_table("a;;b\n1;;2\n1;x;2\n", "t.csv, line 1: column 2 of the header has no name");
}

TEST_CASE("names are kept as they are, whatever they would do as paths") {
  CHECK(table_of("name\n../../etc/passwd\n").rows[0].cells == Cells{"../../etc/passwd"});
  CHECK(table_of("name\n=1+1\n").rows[0].cells == Cells{"=1+1"});
}

TEST_CASE("what is no table is refused with its line") {
  refused_table("", "t.csv is empty; a table begins with the names of its columns");
  refused_table("\n\n", "t.csv is empty; a table begins with the names of its columns");
  refused_table("a,b\n1,2\n1,2,3\n", "t.csv, line 3: fields: 3, but the header has 2");
  refused_table("a,b\n1\n", "t.csv, line 2: fields: 1, but the header has 2");
  refused_table("a,b\n1,\"2\n3,4\n", "t.csv, line 2: a quote is opened and not closed");
  refused_table("a,b\n1,\"2\"x\n",
                "t.csv, line 2: something follows a closing quote; a quote within quotes is written twice");
  refused_table(std::string("a,b\n1,\0\n", 8), "t.csv, line 2: holds a NUL byte; this is no text");
  refused_table("a,b\n1,2\n3,caf\xE9\n", "t.csv, line 3: is not UTF-8; save the table as CSV UTF-8");
  refused_table("a,b\n1,\xC0\x80\n", "t.csv, line 2: is not UTF-8; save the table as CSV UTF-8");
  refused_table("a,,b\n1,2,3\n", "t.csv, line 1: column 2 of the header has no name");
  refused_table("a,b\n1," + std::string(1000001, 'x') + "\n", "t.csv, line 2: is longer than 1000000 bytes");
  refused_table("a,b\n1,\"" + std::string(1000001, 'x') + "\"\n", "t.csv, line 2: is longer than 1000000 bytes");
}

TEST_CASE("a file in Windows-1252, as Excel saves CSV, is read as that, and it is told") {
  const Scratch scratch;
  const auto read = [](const std::string& bytes) {
    std::ofstream("t.csv", std::ios::binary) << bytes;
    return read_csv_file("t.csv");
  };
  const CsvTable table = read("Nome;Quota\r\nNiccol\xF2 D\x92Urso;5 \x80\r\n\xC8ve;\xB1 3\r\n");
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].cells == Cells{"Niccolò D’Urso", "5 €"});
  CHECK(table.rows[1].cells == Cells{"Ève", "± 3"});
  CHECK(table.remark.english.starts_with("t.csv is not UTF-8 and was read as Windows-1252"));
  CHECK(read("Nome\nNiccolò\n").remark.empty());
  const auto refused = [&](const std::string& bytes) {
    CHECK_THROWS_WITH(read(bytes), "t.csv, line 2: is not UTF-8; save the table as CSV UTF-8");
  };
  refused("a\n\xFF\x81\n");                // stands for nothing there
  refused("a\n\xF2 Niccolò\n");            // UTF-8 with a fault
  refused(std::string("a\n\xF2\0\n", 5));  // UTF-16 has such
}

TEST_CASE("columns and numbers that stand there twice, or not at all") {
  const CsvTable twice = table_of("number,name,name\n1,2,3\n1,4,5\n,6,7\n");
  CHECK(twice.column("number") == 0);
  CHECK_FALSE(twice.column("date"));
  CHECK_THROWS_WITH(twice.column("name"), "t.csv: there are two columns \"name\"");
  CHECK_THROWS_WITH(twice.needed_column("nubmer"), "t.csv: there is no column \"nubmer\"; did you mean number?");
  CHECK_THROWS_WITH(twice.demand_distinct(0), "t.csv, line 3: number 1 stands in line 2 already");
  CHECK_THROWS_WITH(table_of("number,x\n1,1\n,2\n").demand_distinct(0), "t.csv, line 3: there is no \"number\"");
}

TEST_CASE("a hundred thousand rows, and not one more") {
  std::string rows = "number;v_B\n";
  for (int i = 1; i <= 100000; ++i) rows += std::to_string(i) + ";5,25\n";
  const CsvTable table = table_of(rows);
  CHECK(table.rows.size() == 100000);
  CHECK(table.rows.back().cells == Cells{"100000", "5,25"});
  CHECK_NOTHROW(table.demand_distinct(0));
  refused_table(rows + "100001;1\n", "t.csv, line 100002: more than 100000 rows");
}

TEST_CASE("files that cannot be read") {
  const Scratch scratch;
  CHECK_THROWS_WITH(read_csv_file("missing.csv"), "cannot read missing.csv: No such file or directory");
  std::filesystem::create_directory("folder");
  CHECK_THROWS_WITH(read_csv_file("folder"), Contains("cannot read folder"));
  std::ofstream("t.csv") << "number\n7\n";
  CHECK(read_csv_file("t.csv").rows[0].cells == Cells{"7"});
}
