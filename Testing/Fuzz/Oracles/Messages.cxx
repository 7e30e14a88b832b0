// SPDX-License-Identifier: GPL-3.0-or-later
#include "Messages.h"

#include <cctype>
#include <regex>

namespace fuzz
{

std::string messageOf(const std::string& eventText)
{
  // "ERROR: In file.cxx, line 1\nvtkClass (0x1234): message\n\n"
  const std::size_t second = eventText.find('\n');
  const std::size_t colon = eventText.find("): ", second == std::string::npos ? 0 : second);
  std::string message = colon == std::string::npos ? eventText : eventText.substr(colon + 3);
  while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back())))
  {
    message.pop_back();
  }
  return message;
}

std::string faultOf(const std::string& message, std::size_t greatestLength)
{
  static const std::regex longNumeral("[0-9.]{20,}");
  static const std::regex overflown("2\\.14748e\\+0?9|vertex -1|point -1|-nan");
  static const std::regex words("[A-Za-z]{2,}[^A-Za-z]+[A-Za-z]+");
  if (message.size() > greatestLength)
  {
    return "is longer than " + std::to_string(greatestLength) + " characters";
  }
  if (message.find('\n') != std::string::npos)
  {
    return "has several lines";
  }
  if (!std::regex_search(message, words))
  {
    return "has no words";
  }
  if (std::regex_search(message, longNumeral))
  {
    return "has a numeral of 20 digits or more";
  }
  if (std::regex_search(message, overflown))
  {
    return "shows a number that is not the user's";
  }
  if (message.find("CGAL") != std::string::npos || message.find("std::") != std::string::npos)
  {
    return "comes from a library";
  }
  return {};
}

} // namespace fuzz
