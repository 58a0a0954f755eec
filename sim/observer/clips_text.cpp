#include "sim/observer/clips_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace npsee::observer {
namespace {

void appendValue(std::string& out, int type, void* value) {
  if (type == STRING) {
    out += '"';
    out += ValueToString(value);
    out += '"';
  } else if (type == INTEGER || type == FLOAT || type == SYMBOL) {
    out += plainText(valueOf(type, value));
  } else if (type == MULTIFIELD) {
    const auto* fields = static_cast<const multifield*>(value);
    for (long i = 0; i < fields->multifieldLength; ++i) {
      if (i > 0) out += ' ';
      appendValue(out, fields->theFields[i].type, fields->theFields[i].value);
    }
  } else {
    out += "<fact>";
  }
}

bool isNothing(const field& slot) {
  if (slot.type == MULTIFIELD) return static_cast<const multifield*>(slot.value)->multifieldLength == 0;
  return (slot.type == SYMBOL && std::string_view(ValueToString(slot.value)) == "nil") || (slot.type == STRING && *ValueToString(slot.value) == '\0');
}

}  // namespace

std::string numberText(double value) {
  if (std::nearbyint(value) == value && std::abs(value) < 1e15) return std::to_string(static_cast<long long>(value));
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return std::string(buffer.data(), end);
}

std::string plainText(const RuleValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return numberText(*number);
  if (const auto* symbol = std::get_if<Symbol>(&value)) return symbol->text;
  return std::get<std::string>(value);
}

std::string sentence(std::string_view message) {
  if (const auto echo = message.find("ERROR:"); echo != std::string_view::npos) message = message.substr(0, echo);
  std::string out;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const char c = message[i];
    if (c == '[' && (out.empty() || out.back() == ' ')) {
      if (const auto end = message.find(']', i); end != std::string_view::npos && end - i < 16) {
        i = end;
        continue;
      }
    }
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (space ? !out.empty() && out.back() != ' ' : true) out += space ? ' ' : c;
  }
  while (!out.empty() && out.back() == ' ') out.pop_back();
  if (!out.empty() && out.back() != '.') out += '.';
  return printable(out);
}

RuleValue valueOf(int type, void* value) {
  switch (type) {
    case INTEGER: return static_cast<std::int64_t>(ValueToLong(value));
    case FLOAT: return ValueToDouble(value);
    case SYMBOL: return Symbol{ValueToString(value)};
    case STRING: return std::string(ValueToString(value));
    default: break;
  }
  throw std::invalid_argument("expected a number, a word or a text");
}

void setValue(void* env, dataObject& out, const RuleValue& value) {
  out = {};
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    out.type = INTEGER;
    out.value = EnvAddLong(env, *whole);
  } else if (const auto* number = std::get_if<double>(&value)) {
    out.type = FLOAT;
    out.value = EnvAddDouble(env, *number);
  } else if (const auto* symbol = std::get_if<Symbol>(&value)) {
    out.type = SYMBOL;
    out.value = EnvAddSymbol(env, symbol->text.c_str());
  } else {
    out.type = STRING;
    out.value = EnvAddSymbol(env, std::get<std::string>(value).c_str());
  }
}

std::string factText(const fact& given) {
  std::string out = std::string("(") + ValueToString(given.whichDeftemplate->header.name);
  const templateSlot* slot = given.whichDeftemplate->slotList;
  for (long i = 0; i < given.theProposition.multifieldLength; ++i) {
    const field& value = given.theProposition.theFields[i];
    if (slot == nullptr) {
      if (value.type != MULTIFIELD || static_cast<const multifield*>(value.value)->multifieldLength > 0) out += ' ';
      appendValue(out, value.type, value.value);
      continue;
    }
    if (!isNothing(value)) {
      out += std::string(" (") + ValueToString(slot->slotName) + ' ';
      appendValue(out, value.type, value.value);
      out += ')';
    }
    slot = slot->next;
  }
  return out + ')';
}

}  // namespace npsee::observer
