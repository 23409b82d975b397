#include "exercises/cli/help.h"

namespace epure {

Help help_of_program() {
  return {
      {"The graphical constructions of applied mechanics, carried out exactly, drawn to scale, and checked.",
       "Le costruzioni grafiche della meccanica applicata, eseguite esattamente, disegnate in scala e verificate."},
      {"EPURE_LANG=it in the environment stands for --lang it. Colours are for terminals; NO_COLOR=1 leaves them "
       "out.",
       "EPURE_LANG=it nell'ambiente vale --lang it. I colori sono per i terminali; NO_COLOR=1 li toglie."},
      R"(
  epure list
  epure draw all
  epure check all
  epure help draw
)"};
}

Help help_of_list() {
  return {{"Show the exercises, or all about one of them.", "Mostra gli esercizi, o tutto di uno."},
          {},
          R"(
  epure list
  epure list slider-crank-velocity
  epure list watt-six-bar
  epure list slider-crank-velocity --lang it
  epure list --json > exercises.json
)"};
}

Help help_of_draw() {
  return {
      {"Draw exercises to scale, as PDF and SVG.", "Disegna gli esercizi in scala, in PDF e SVG."},
      {"draw ID writes out/ID.pdf with a page a sheet, and out/ID-SHEET.svg for each sheet; draw ID/SHEET writes "
       "that sheet alone in both formats. A long table takes as many pages as it needs: of its sheet the further "
       "ones "
       "are out/ID-SHEET-2.svg and so on, and --format csv writes its numbers to out/ID-SHEET.csv, for a "
       "spreadsheet. html is a page for a browser, with a slider through the steps of the construction. png and eps "
       "hold a page each; pdf+tex is a bare figure whose letters LaTeX sets: \\input "
       "ID-SHEET.tex, beside ID-SHEET-art.pdf. Files appear whole or not at all. A value is a number such as 0.25, "
       "1/4 "
       "or 2.5e-1, with a unit (25cm) or in that which list shows. --givens reads such values from a file; of a "
       "table "
       "each row is drawn, to out/ID-NUMBER.pdf and out/ID-SHEET-NUMBER.svg, or as --name has it.",
       "draw ID scrive out/ID.pdf con una pagina per tavola, e out/ID-TAVOLA.svg per ogni tavola; draw ID/TAVOLA "
       "scrive quella sola tavola in entrambi i formati. Una tabella lunga prende quante pagine le servono: della "
       "sua "
       "tavola le altre sono out/ID-TAVOLA-2.svg e così via, e --format csv ne scrive i numeri in out/ID-TAVOLA.csv, "
       "per un foglio di calcolo. html è una pagina per il browser, con un cursore per i passi della costruzione. "
       "png ed eps contengono una pagina ciascuno; pdf+tex è una figura nuda di cui LaTeX "
       "compone le lettere: \\input ID-TAVOLA.tex, accanto a ID-TAVOLA-art.pdf. I file compaiono interi o non "
       "compaiono. Un valore è un "
       "numero come 0,25, 1/4 o 2,5e-1, con un'unità (25cm) o in quella che list mostra. --givens legge tali valori "
       "da un "
       "file; di una tabella si disegna ogni riga, in out/ID-NUMERO.pdf e out/ID-TAVOLA-NUMERO.svg, o come vuole "
       "--name."},
      R"(
  epure draw slider-crank-velocity
  epure draw slider-crank-velocity --set r=25cm --set n=400rpm --paper a3
  epure draw slider-crank-velocity/poles --scale 1:10 -o poles.pdf
  epure draw slider-crank-velocity/poles --bare --format svg -o - > poles.svg
  epure draw slider-crank-velocity/poles --width 120mm -o poles.tex
  epure draw slider-crank-velocity/poles -o poles.png --background '#1e1e2e'
  epure draw slider-crank-velocity/polar-diagram -o polar-diagram.html
  epure draw slider-crank-velocity --steps --bare -o overlays.pdf
  epure draw four-bar --givens students.csv --name '{id}-{student}-{sheet}'
)"};
}

Help help_of_check() {
  return {
      {"Check every quantity: route against route, against the drawing, against the printed number.",
       "Verifica ogni grandezza: via contro via, contro il disegno, contro il numero stampato."},
      {"A quantity passes when all its routes agree within proved bounds, and when its drawing, as the file holds "
       "it, shows it. A measured number passes when it is within reading: --reading times the scale of its "
       "drawing; for a quantity that is calculated, what that is worth in the drawn ones it comes from; in any case "
       "half a unit of its last digit, when it has two. A number without a sign is a magnitude. fast gives numbers "
       "without bounds, so its routes cannot be compared. JSON is English in "
       "every language.",
       "Una grandezza riesce quando tutte le sue vie concordano entro limiti dimostrati, e quando il disegno, "
       "come sta nel file, la mostra. Un numero misurato riesce quando è entro l'errore di lettura: --reading "
       "per la scala del disegno; per una grandezza calcolata, quanto ciò vale nelle disegnate da cui viene; in ogni "
       "caso mezza unità della sua ultima cifra, se ne ha due. Un numero senza segno è un modulo. fast dà numeri "
       "senza limiti, dunque le sue vie non si possono confrontare. Il "
       "JSON è in inglese in ogni lingua."},
      R"(
  epure check all
  epure check slider-crank-velocity --set r=25cm
  epure check slider-crank-velocity --measured v_B=5.1m/s --measured omega_3=13
  epure check slider-crank-velocity --json
)"};
}

Help help_of_report() {
  return {
      {"Write a worked solution: question, givens, figures, each step, results with bounds, the source's numbers.",
       "Scrive una soluzione svolta: quesito, dati, figure, ogni passo, risultati con limiti, i numeri della fonte."},
      {"Writes out/ID-report.md and out/ID-report-SHEET.svg; for tex the figures are PDFs, true to scale at the "
       "width "
       "of the page, and html holds them itself. Markdown has mathematics between dollar signs, as pandoc, GitHub "
       "and "
       "notebooks read it. Every number is one that epure check has checked; it exits as check does.",
       "Scrive out/ID-report.md e out/ID-report-TAVOLA.svg; per tex le figure sono PDF, in scala alla larghezza "
       "della "
       "pagina, e html le contiene. Il Markdown ha la matematica tra segni di dollaro, come la leggono pandoc, "
       "GitHub "
       "e i notebook. Ogni numero è uno che epure check ha verificato; esce come check."},
      R"(
  epure report slider-crank-velocity
  epure report slider-crank-velocity --set r=25cm -o solution.html
  epure report four-bar --format tex --lang it --out reports
)"};
}

Help help_of_booklet() {
  return {
      {"Bind all exercises, or those named, into one PDF with a title page and contents.",
       "Raccoglie tutti gli esercizi, o quelli nominati, in un PDF con frontespizio e indice."},
      {"Writes out/booklet.pdf, or the file of -o. The contents lead to the sheets, whose title blocks tell the "
       "page; "
       "a reader shows exercises and sheets as bookmarks.",
       "Scrive out/booklet.pdf, o il file di -o. L'indice conduce alle tavole, il cui riquadro dice la pagina; un "
       "lettore mostra esercizi e tavole come segnalibri."},
      R"(
  epure booklet
  epure booklet slider-crank-velocity four-bar --lang it -o lezioni.pdf
  epure booklet --paper a3 --course "Applied mechanics" --out print
)"};
}

Help help_of_sweep() {
  return {
      {"Find quantities of an exercise at all values of some of its givens, each with bounds, for other programs.",
       "Trova grandezze di un esercizio per tutti i valori di alcuni suoi dati, ognuna con limiti, per altri "
       "programmi."},
      {"Each line holds the values of --over, exactly, and each quantity in SI units: the double nearest "
       "to it, or beside that, and bounds that enclose it. Every route of the exercise finds it; one "
       "suffices to prove it, and where two cannot both be right the line says so (exit 1). What does not "
       "exist has its reason; faults of gears (teeth that are pointed, undercut, interfere) stand in the last "
       "column. The last --over changes with every line. After the last slash stands a count "
       "when it is a whole number alone, and a step when it has a decimal point or a unit. A list is "
       "quoted, as a shell takes | for its own. Lines come in order while all processors find the next "
       "ones, in as much memory as a few of them take; a file appears whole or not at all. The parts one "
       "after the other are the whole, to the byte. CSV and JSON have decimal points and are English in "
       "every language, but for --csv excel. A chart's axis is the given of the first --over, and each value of the "
       "others has a curve: so name the one with the many values first.",
       "Ogni riga ha i valori di --over, esatti, e ogni grandezza in unità SI: il double più vicino o "
       "quello accanto, e i limiti che la racchiudono. La trovano tutte le vie dell'esercizio; una basta a "
       "dimostrarla, e dove due non possono essere giuste insieme la riga lo dice (uscita 1). Ciò che non "
       "esiste ha il suo motivo; i difetti delle ruote dentate (denti a punta, sottotagliati, che "
       "interferiscono) stanno nell'ultima colonna. L'ultimo --over cambia a ogni riga. Dopo l'ultima barra sta "
       "quanti valori "
       "quando è un intero da solo, e un passo quando ha la virgola o un'unità. Un elenco va tra apici, "
       "perché la shell prende | per sé. Le righe escono in ordine mentre tutti i processori trovano le "
       "prossime, nella memoria che ne prendono poche; un file compare intero o non compare. Le parti una "
       "dopo l'altra sono il tutto, byte per byte. CSV e JSON hanno il punto decimale e sono in inglese "
       "in ogni lingua, tranne con --csv excel. L'asse di un grafico è il dato del primo --over, e ogni valore degli "
       "altri ha una curva: nominare dunque per primo quello che ha molti valori."},
      R"(
  epure sweep slider-crank-velocity --over phi=0deg..360deg/361 --quantity v_B
  epure sweep slider-crank-velocity --over r=0.18..0.22/0.01 \
    --over phi=0..350/36 --quantity v_B,P0_x -o v_B.csv
  epure sweep four-bar-analytic --over 'branch=left|right' \
    --over phi=0..360/1.0 --quantity omega_4 --format json
  epure sweep rivals-polygons --over phi=0..360/361 --quantity omega_3 \
    --chart omega_3.pdf -o omega_3.csv
  epure sweep slider-crank-velocity --over phi=0..360/361 \
    --over 'r=0.18|0.2|0.22' --quantity v_B \
    --chart v_B.pdf --csv excel -o v_B.csv
  epure sweep slider-crank-velocity --over phi=0..360/73 --quantity v_B \
    -o v_B.html
)"};
}

Help help_of_class() {
  return {
      {"Make a class set: for each student a sheet to be solved and its solution, and a key of all.",
       "Prepara le tavole di una classe: per ogni studente una da svolgere e la soluzione, e una chiave di tutte."},
      {"Files go to ID-class in the folder of --out: NUMBER-blank.pdf, NUMBER-solution.pdf and key.csv, which mark "
       "reads. Givens are drawn by lot, each student's by the seed and his number alone; what is impossible, or "
       "cannot be "
       "drawn well (a vector below 10 mm, lines that meet at less than 15°, a step off the paper, a point at "
       "infinity), "
       "is drawn again, and counted; so are students with equal givens. What lies off the paper or at infinity is "
       "not "
       "asked. A run that was stopped goes on where it stood; class.txt has its command, and over a class of other "
       "--seed, --vary or --set none is made. All have one scale of lengths where one fits all. moodle writes "
       "questions.xml instead of the sheets, "
       "cloze "
       "questions with the figure inside. --csv excel writes a key that a spreadsheet with decimal commas opens; "
       "mark "
       "reads both.",
       "I file vanno in ID-class nella cartella di --out: NUMERO-blank.pdf, NUMERO-solution.pdf e key.csv, che mark "
       "legge. I dati sono sorteggiati, quelli di ogni studente secondo il seme e il suo numero soltanto; ciò che è "
       "impossibile o si disegna male (un vettore sotto i 10 mm, rette che si incontrano a meno di 15°, un passo "
       "fuori del foglio, un punto all'infinito) è sorteggiato di nuovo, e contato; contati sono anche gli studenti "
       "con "
       "dati uguali. Ciò che sta fuori del foglio o all'infinito non si chiede. Un'esecuzione interrotta riprende da "
       "dov'era; class.txt ne ha il comando, e sopra una classe di altri --seed, --vary o --set non se ne fa "
       "un'altra. "
       "Tutti hanno una sola scala delle lunghezze, se va bene a tutti. moodle scrive questions.xml al posto delle "
       "tavole, domande cloze con la figura dentro. --csv excel scrive una chiave che un foglio di calcolo con "
       "virgole decimali apre; mark le legge entrambe."},
      R"(
  epure class slider-crank-velocity --students roster.csv \
    --vary r=0.18..0.22/0.01 --scale 1:10 --booklet
  epure class four-bar/poles --count 30 --vary "phi=20|35|50|65" --seed june
  epure class slider-crank-velocity/poles --count 40 \
    --vary phi=20deg..70deg/26 --format moodle
)"};
}

Help help_of_mark() {
  return {
      {"Mark what a class measured: points for each quantity, with the typical slips named.",
       "Valuta ciò che una classe ha misurato: punti per ogni grandezza, con le sviste tipiche riconosciute."},
      {"The answers are CSV as spreadsheets write it (comma, semicolon or tabulator; decimal commas; UTF-8). An "
       "answer "
       "is right when it is within reading: --reading at the student's own scale (column scale: 1:5; scale_velocity "
       "and so on: 1 cm = 2 m/s, or 2 m/s per cm), else at that of epure's sheet; for what is calculated, what that "
       "is "
       "worth in the drawn quantities it comes from. More digits are never worth less; fewer are worth half a unit "
       "of "
       "the last one, when there are two. A number without a sign is a magnitude, also for Moodle. Of \"circa 3.2\" "
       "or "
       "\"3.2?\" the number counts, and a remark tells it. An answer that is no number costs that answer, a column "
       "that is no quantity that column; one that nearly is a quantity is refused. Givens are "
       "those "
       "of --key, else of the answers, else of --set, else the stated ones. In CSV a "
       "name that begins with =, +, - or @ stands behind an apostrophe, so that no spreadsheet runs it.",
       "Le risposte sono un CSV come lo scrivono i fogli di calcolo (virgola, punto e virgola o tabulatore; virgola "
       "decimale; UTF-8). Una risposta è giusta quando è entro l'errore di lettura: --reading nella scala dello "
       "studente (colonna scale: 1:5; scale_velocity e così via: 1 cm = 2 m/s, o 2 m/s al cm), altrimenti in quella "
       "della tavola di epure; per ciò che è calcolato, quanto ciò vale nelle grandezze disegnate da cui viene. Più "
       "cifre non valgono mai meno; meno cifre valgono mezza unità dell'ultima, se sono due. Un numero senza segno è "
       "un modulo, anche per Moodle. Di \"circa 3,2\" o \"3,2?\" vale il numero, e un'osservazione lo dice. Una "
       "risposta che non è un numero costa quella risposta, una colonna che non è una grandezza "
       "quella "
       "colonna; una che quasi lo è viene rifiutata. I dati sono quelli di --key, altrimenti "
       "delle risposte, di --set o della fonte. Nel CSV un nome che comincia con =, +, - o @ sta dietro un "
       "apostrofo, "
       "perché nessun foglio di calcolo lo esegua."},
      R"(
  epure mark slider-crank-velocity --answers answers.csv
  epure mark four-bar --answers answers.csv --key key.csv --out-of 30 \
    -o marks.csv
  epure mark four-bar --answers answers.csv --scale 1:4 --points v_B=2
  epure mark four-bar --answers risposte.csv --key key.csv \
    --lang it --csv excel -o voti.csv
)"};
}

Help help_of_import() {
  return {{"Make a mechanism's file of what pyslvs or PMKS+ have.",
           "Fa il file di un meccanismo da ciò che hanno pyslvs o PMKS+."},
          {"Joints keep their coordinates and become A, B, C ... in their order; shapes of the links and sides of "
           "the joints "
           "are read off them. What is taken for granted stands on standard error. What a file cannot say is "
           "refused, and "
           "nothing is written.",
           "I nodi tengono le loro coordinate e diventano A, B, C ... nel loro ordine; se ne leggono le forme dei "
           "membri e "
           "le parti dei nodi. Ciò che si sottintende sta sullo standard error. Ciò che un file non può dire è "
           "rifiutato, "
           "e nulla è scritto."},
          R"(
  epure import 'M[J[R, P[0, 0], L[ground, L1]], ...]' -o mine.yaml
  epure import 'https://app.pmksplus.com/?2P.Ay...' > mine.yaml
  epure import - -o mine.yaml < link.txt
)"};
}

Help help_of_bench() {
  return {
      {"Measure speed against error, and draw it.", "Misura la velocità contro l'errore, e la disegna."},
      {"Every family of constructions, at and beside its special positions, with every number: fast (doubles), "
       "bounded (intervals), deep (as many bits as 30 digits take), exact. Errors are those made against "
       "references of at least 110 digits; handed over is what a number leaves to the next one, for deep what "
       "takes more than 128 bits; wrong counts what doubles call a number though it is zero or does not exist. "
       "Times are of the cases that a number settles, those of four-bar-second-order by fast and bounded of a "
       "sweep. Then which number proves each decision, curves drawn to a tolerance, and where the time of whole "
       "sheets goes. Writes out/bench.pdf and out/bench-*.svg; what it measures next goes to standard error. Its "
       "table is in English.",
       "Ogni famiglia di costruzioni, nelle sue posizioni particolari e accanto, con ogni numero: fast (double), "
       "bounded (intervalli), deep (tanti bit quanti ne vogliono 30 cifre), exact. Gli errori sono quelli fatti "
       "rispetto a riferimenti di almeno 110 cifre; handed over è ciò che un numero lascia al successivo, per "
       "deep ciò che vuole più di 128 bit; wrong conta ciò che i double chiamano numero benché sia zero o non "
       "esista. I tempi sono dei casi che un numero risolve, quelli di four-bar-second-order con fast e bounded "
       "di un giro. Poi quale numero dimostra ogni decisione, le curve disegnate con una tolleranza, e dove va il "
       "tempo di tavole intere. Scrive out/bench.pdf e out/bench-*.svg; ciò che misura va via via sullo standard "
       "error. La sua tabella è in inglese."},
      R"(
  epure bench
  epure bench --json > bench.json
  epure bench --seconds 5 --out bench
)"};
}

Words exit_codes() {
  return {
      "Exit code: 0 good; 1 a check fails; 2 wrong usage or impossible givens; 3 cannot write, or no memory, thread "
      "or "
      "font was to be had; 4 something could not be decided, and nothing is worse; 70 an internal error: please "
      "report "
      "it.",
      "Codice di uscita: 0 tutto bene; 1 una verifica fallisce; 2 uso sbagliato o dati impossibili; 3 non si può "
      "scrivere, o mancano memoria, thread o caratteri; 4 qualcosa non si è potuto decidere, e non c'è di peggio; 70 "
      "un "
      "errore interno: si prega di segnalarlo."};
}

}  // namespace epure
