// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WarpGraph.h"

#include "Core/Base/EigenVersions.h"
#include "Core/Base/Errors.h"
#include "Internal/ArrayConversion.h"
#include "Internal/PolyDataConversion.h"

#include <vtkDataSetAttributes.h>
#include <vtkDirectedGraph.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkMutableDirectedGraph.h>
#include <vtkMutableUndirectedGraph.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUndirectedGraph.h>
#include <vtkUnsignedCharArray.h>

#include <vector>

namespace flattening
{
namespace
{

Points3 positionsOf(vtkGraph* graph)
{
  // If the graph has too few points, GetPoints() puts all vertices at the origin, which is an error
  // below; GetPoint() would read beyond the last one.
  graph->GetPoints();
  Points3 positions(graph->GetNumberOfVertices(), 3);
  for (vtkIdType v = 0; v < positions.rows(); ++v)
  {
    graph->GetPoint(v, positions.row(v).data());
  }
  if (positions.rows() > 1 && (positions.rowwise() - positions.row(0)).isZero(0.0))
  {
    throw InvalidInput("the vertices of the graph all have the same position: lay the graph out first");
  }
  return positions;
}

// The edge as a polyline: its two vertices, its own edge points, and new ones where segments are long.
std::vector<Eigen::Vector3d> polylineOf(vtkGraph* graph,
  vtkIdType edge,
  const Points3& vertices,
  const WarpRules& rules,
  WarpCounts& counts)
{
  std::vector<Eigen::Vector3d> corners{ vertices.row(graph->GetSourceVertex(edge)) };
  for (vtkIdType k = 0; k < graph->GetNumberOfEdgePoints(edge); ++k)
  {
    corners.emplace_back(graph->GetEdgePoint(edge, k));
  }
  corners.emplace_back(vertices.row(graph->GetTargetVertex(edge)));
  std::vector<Eigen::Vector3d> line{ corners.front() };
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
  {
    const int parts = segmentParts(corners[k], corners[k + 1], rules);
    counts.Inserted += parts - 1;
    requireRoomFor(counts.Inserted);
    for (int part = 1; part <= parts; ++part)
    {
      const double share = static_cast<double>(part) / parts;
      line.emplace_back((1.0 - share) * corners[k] + share * corners[k + 1]);
    }
  }
  return line;
}

// The x, y, z of the warped points between the ends of an edge.
std::vector<double> warpedEdgePoints(const std::vector<Eigen::Vector3d>& line, const WarpRules& rules)
{
  Points3 between(static_cast<Eigen::Index>(line.size()) - 2, 3);
  for (Eigen::Index k = 0; k < between.rows(); ++k)
  {
    between.row(k) = line[k + 1];
  }
  WarpRules silent = rules;
  silent.Progress = {};
  const WarpedInSpace warped = warpInSpace(between, silent);
  std::vector<double> points;
  for (Eigen::Index k = 0; k < between.rows(); ++k)
  {
    if (warped.Inside[k] || !rules.RemoveOutside)
    {
      const auto* x = warped.Positions.row(k).data();
      points.insert(points.end(), x, x + 3);
    }
  }
  return points;
}

void copyTuples(vtkDataSetAttributes* from,
  const std::vector<vtkIdType>& tuples,
  vtkDataSetAttributes* to)
{
  to->CopyAllOn();
  to->CopyAllocate(from, static_cast<vtkIdType>(tuples.size()));
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    to->CopyData(from, tuples[i], static_cast<vtkIdType>(i));
  }
}

// The warped graph as it is built, a vtkMutableDirectedGraph or vtkMutableUndirectedGraph.
template <typename Builder>
class GraphWarp
{
public:
  GraphWarp(vtkGraph* input, const WarpRules& rules)
    : Input(input)
    , Rules(rules)
    , Before(positionsOf(input))
    , KeptAs(this->Before.rows(), -1)
  {
  }

  void addVertices()
  {
    const WarpedInSpace warped = warpInSpace(this->Before, this->Rules);
    requireSomeInside(warped, this->Before);
    std::vector<vtkIdType> kept;
    std::vector<char> inMap;
    for (vtkIdType v = 0; v < this->Before.rows(); ++v)
    {
      this->Counts.Outside += warped.Inside[v] == 0;
      if (warped.Inside[v] || !this->Rules.RemoveOutside)
      {
        this->KeptAs[v] = this->Graph->AddVertex();
        kept.push_back(v);
        inMap.push_back(warped.Inside[v]);
      }
    }
    vtkNew<vtkPoints> points;
    points->SetData(
      newTuples<vtkDoubleArray>("Points", Points3(warped.Positions(kept, flattening::all))));
    this->Graph->SetPoints(points);
    vtkDataSetAttributes* data = this->Graph->GetVertexData();
    copyTuples(this->Input->GetVertexData(), kept, data);
    data->AddArray(
      newTuples<vtkDoubleArray>(SurfacePointsName, Points3(this->Before(kept, flattening::all))));
    data->AddArray(newArray<vtkUnsignedCharArray>(InMapName, inMap));
  }

  void addEdges()
  {
    std::vector<vtkIdType> kept;
    for (vtkIdType e = 0; e < this->Input->GetNumberOfEdges(); ++e)
    {
      const vtkIdType source = this->KeptAs[this->Input->GetSourceVertex(e)];
      const vtkIdType target = this->KeptAs[this->Input->GetTargetVertex(e)];
      if (source >= 0 && target >= 0)
      {
        const vtkIdType id = this->Graph->AddEdge(source, target).Id;
        const std::vector<double> between = warpedEdgePoints(
          polylineOf(this->Input, e, this->Before, this->Rules, this->Counts), this->Rules);
        this->Graph->SetEdgePoints(id, static_cast<vtkIdType>(between.size() / 3), between.data());
        kept.push_back(e);
      }
    }
    copyTuples(this->Input->GetEdgeData(), kept, this->Graph->GetEdgeData());
  }

  WarpCounts write(vtkGraph* output)
  {
    this->Graph->GetFieldData()->PassData(output->GetFieldData()); // that of the flat map
    output->CheckedShallowCopy(this->Graph);
    return this->Counts;
  }

private:
  vtkGraph* Input;
  const WarpRules& Rules;
  Points3 Before;                // positions of the input's vertices
  std::vector<vtkIdType> KeptAs; // number of each vertex in the output; -1: not kept
  vtkNew<Builder> Graph;
  WarpCounts Counts;
};

template <typename Builder>
WarpCounts warp(vtkGraph* input, const WarpRules& rules, vtkGraph* output)
{
  GraphWarp<Builder> graph(input, rules);
  graph.addVertices();
  graph.addEdges();
  return graph.write(output);
}

} // namespace

WarpCounts warpGraph(vtkGraph* input, const WarpRules& rules, vtkGraph* output)
{
  return vtkDirectedGraph::SafeDownCast(input) ? warp<vtkMutableDirectedGraph>(input, rules, output)
                                               : warp<vtkMutableUndirectedGraph>(input, rules, output);
}

} // namespace flattening
