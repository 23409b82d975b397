#include "drawings/files/system_words.h"

#include <cerrno>
#include <cstring>

namespace epure::drawings {
namespace {

const char* in_italian(int error) {
  switch (error) {
    case EACCES:
      return "permesso negato";
    case EBADF:
      return "descrittore di file non valido";
    case EDQUOT:
      return "quota del disco superata";
    case EEXIST:
      return "il file esiste già";
    case EFBIG:
      return "file troppo grande";
    case EIO:
      return "errore di ingresso/uscita";
    case EISDIR:
      return "è una cartella";
    case ELOOP:
      return "troppi collegamenti simbolici";
    case EMFILE:
    case ENFILE:
      return "troppi file aperti";
    case ENAMETOOLONG:
      return "nome troppo lungo";
    case ENOENT:
      return "il file o la cartella non esiste";
    case ENOSPC:
      return "non c'è più spazio";
    case ENOTDIR:
      return "non è una cartella";
    case EPERM:
      return "operazione non permessa";
    case EPIPE:
      return "nessuno legge più";
    case EROFS:
      return "file system di sola lettura";
    default:
      return nullptr;
  }
}

}  // namespace

Words system_words(int error) {
  const std::string english = std::strerror(error);
  const char* const italian = in_italian(error);
  return {english, italian ? italian : english};
}

}  // namespace epure::drawings
