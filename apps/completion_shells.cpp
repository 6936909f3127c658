/// The parts of the completion that are written in shell language.
#include "apps/completion.hpp"

namespace riedel {

std::string_view completion_rules() {
  return R"sh(
# Whether the option $2 of the command $1 takes a value.
_riedel_takes_value() {
  _riedel_table "valued $1" | grep -qxF -e "$2"
}

# The words $2 of a table, each with the prefix $1.
_riedel_behind() {
  _riedel_table "$2" | while IFS= read -r word; do
    case $word in
      @*) printf '%s\n' "$word" ;;
      *) printf '%s\n' "$1$word" ;;
    esac
  done
}

# A key, or a value of one, of the command $1, its first word $2, the law $3 and the word begun $4.
_riedel_setting() {
  case $4 in
    *=*,*) _riedel_behind "${4%,*}," "values ${4%%=*}" ;;
    *=*) _riedel_behind "${4%%=*}=" "values ${4%%=*}" ;;
    *)
      case $1 in
        element) _riedel_table "keys element ${2:-triaxial}" ;;
        umat-check) _riedel_table 'keys umat-check' ;;
        check) _riedel_table 'keys biaxial'; echo test= ;;
        *) _riedel_table 'keys biaxial' ;;
      esac
      [ "$1" = umat-check ] || _riedel_table "law $3"
      ;;
  esac
}

# The value of the option $2 of the command $1, of which $3 is begun.
_riedel_value() {
  local prefix=
  if [ -n "$(_riedel_table "list $1 $2")" ]; then
    case $3 in
      *,*) prefix=${3%,*}, ;;
    esac
  fi
  _riedel_behind "$prefix" "value $1 $2"
}

# Completions of the word $1, typed after the words that follow. @dir and @file with an ending stand for files.
_riedel_candidates() {
  local begun=$1 command=$2 first= law=gudehus_bauer option= count=0 word
  shift
  if [ $# -eq 0 ]; then
    case $begun in
      -*) _riedel_table switches ;;
      *) _riedel_table commands ;;
    esac
    return
  fi
  shift
  case $command in
    help) [ $# -eq 0 ] && _riedel_table commands; return ;;
    --completion) _riedel_table shells; return ;;
  esac
  for word in "$@"; do
    case $word in
      material.model=*) law=${word#*=} ;;
    esac
    if [ -n "$option" ]; then
      option=
      continue
    fi
    [ "$word" = -o ] && word=--out
    case $word in
      -*) _riedel_takes_value "$command" "$word" && option=$word ;;
      *)
        count=$((count + 1))
        [ $count -eq 1 ] && first=$word
        ;;
    esac
  done
  case $option:$begun in
    --set:* | --vary:*) _riedel_setting "$command" "$first" "$law" "$begun" ;;
    --*:*) _riedel_value "$command" "$option" "$begun" ;;
    :--*=*) _riedel_value "$command" "${begun%%=*}" "${begun#*=}" ;;
    :-*) _riedel_table "options $command" ;;
    *)
      word=$((count + 1))
      [ "$command" = list ] && word=more
      _riedel_table "word $command $word"
      ;;
  esac
}
)sh";
}

std::string_view completion_frontend(std::string_view shell) {
  if (shell == "bash")
    return R"sh(
_riedel() {
  # readline breaks words at '='; here they are whole again
  local -a words=()
  local i part glue=0
  for ((i = 1; i <= COMP_CWORD; i++)); do
    part=${COMP_WORDS[i]}
    if [[ $part == = && ${#words[@]} -gt 0 ]]; then
      words[${#words[@]} - 1]+==
      glue=1
    elif [[ $glue == 1 && $part != --* ]]; then
      words[${#words[@]} - 1]+=$part
      glue=0
    else
      words+=("$part")
      glue=0
    fi
  done
  local last=$((${#words[@]} - 1))
  local begun=${words[last]-} typed=${COMP_WORDS[COMP_CWORD]-} word
  [[ $typed == = ]] && typed=
  local broken=${begun%"$typed"} # in front of what readline will replace
  COMPREPLY=()
  while IFS= read -r word; do
    case $word in
      @dir) mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "$typed"); compopt -o filenames 2>/dev/null ;;
      @file*)
        mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -d -- "$typed"; compgen -f -X "!*${word#@file}" -- "$typed")
        compopt -o filenames 2>/dev/null
        ;;
      "$begun"*)
        COMPREPLY+=("${word#"$broken"}")
        [[ $word == *= ]] && compopt -o nospace 2>/dev/null
        ;;
    esac
  done < <(_riedel_candidates "$begun" "${words[@]:0:last}")
}
complete -F _riedel riedel
)sh";
  return R"sh(
_riedel() {
  local -a found names
  found=(${(f)"$(_riedel_candidates "${words[CURRENT]}" "${(@)words[2,CURRENT-1]}")"})
  names=(${found:#@*})
  (( ${#names} )) && compadd -S '' -- ${(M)names:#*=}
  (( ${#names} )) && compadd -- ${names:#*=}
  found=(${(M)found:#@*})
  (( ${#found} )) || return 0
  [[ ${words[CURRENT]} == *=* ]] && compset -P 1 '*='
  if [[ $found[1] == @dir ]]; then
    _files -/
  else
    _files -g "*${found[1]#@file}(-.)"
  fi
}
if [[ ${funcstack[1]} == _riedel ]]; then
  _riedel "$@"
else
  compdef _riedel riedel
fi
)sh";
}

} // namespace riedel
