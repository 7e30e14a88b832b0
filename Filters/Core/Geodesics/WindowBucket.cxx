// SPDX-License-Identifier: GPL-3.0-or-later
#include "Geodesics/WindowBucket.h"

#include <algorithm>

namespace flattening
{

double GeodesicWindow::distanceAt(double position) const
{
  return this->Before + planarNorm(position - this->X, this->Y);
}

double GeodesicWindow::nearest() const
{
  return this->distanceAt(std::clamp(this->X, this->Begin, this->End));
}

bool WindowBucket::isPlaceNext() const
{
  return !this->Places.empty() && (!this->IsSorted || this->Windows.empty() ||
                                    this->Places.front().Distance <= this->Windows.front().Nearest);
}

PlaceEvent WindowBucket::takePlace()
{
  std::pop_heap(this->Places.begin(), this->Places.end());
  const PlaceEvent place = this->Places.back();
  this->Places.pop_back();
  return place;
}

GeodesicWindow WindowBucket::takeWindow()
{
  if (!this->IsSorted)
  {
    return this->Windows[this->NextWindow++];
  }
  std::pop_heap(this->Windows.begin(), this->Windows.end());
  const GeodesicWindow window = this->Windows.back();
  this->Windows.pop_back();
  return window;
}

void WindowBucket::add(const PlaceEvent& place)
{
  this->Places.push_back(place);
  std::push_heap(this->Places.begin(), this->Places.end());
}

void WindowBucket::add(const GeodesicWindow& window)
{
  this->Windows.push_back(window);
  if (this->IsSorted)
  {
    std::push_heap(this->Windows.begin(), this->Windows.end());
  }
}

void WindowBucket::sort()
{
  this->Windows.erase(
    this->Windows.begin(), this->Windows.begin() + static_cast<std::ptrdiff_t>(this->NextWindow));
  this->NextWindow = 0;
  this->IsSorted = true;
  std::make_heap(this->Windows.begin(), this->Windows.end());
}

void WindowBucket::clear()
{
  this->Places.clear();
  this->Windows.clear();
  this->NextWindow = 0;
  this->IsSorted = false;
}

} // namespace flattening
