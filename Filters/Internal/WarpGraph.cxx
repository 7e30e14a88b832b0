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

// The points of an edge between its ends.
struct EdgePoints
{
  std::vector<Eigen::Vector3d> Positions;
  std::vector<char> Inserted; // 1 for a new point, 0 for one of the edge points of the input
};

// The edge points of an edge, and new ones where segments are long.
// @param insertedBefore the number of points that other edges got.
EdgePoints pointsBetween(vtkGraph* graph,
  vtkIdType edge,
  const Points3& vertices,
  const WarpRules& rules,
  long long insertedBefore)
{
  std::vector<Eigen::Vector3d> corners{ vertices.row(graph->GetSourceVertex(edge)) };
  for (vtkIdType k = 0; k < graph->GetNumberOfEdgePoints(edge); ++k)
  {
    corners.emplace_back(graph->GetEdgePoint(edge, k));
  }
  corners.emplace_back(vertices.row(graph->GetTargetVertex(edge)));
  EdgePoints between;
  long long inserted = insertedBefore;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
  {
    const int parts = segmentParts(corners[k], corners[k + 1], rules);
    inserted += parts - 1;
    requireRoomFor(inserted);
    for (int part = 1; part <= parts; ++part)
    {
      const double share = static_cast<double>(part) / parts;
      between.Positions.emplace_back((1.0 - share) * corners[k] + share * corners[k + 1]);
      between.Inserted.push_back(part < parts);
    }
  }
  between.Positions.pop_back(); // the target
  between.Inserted.pop_back();
  return between;
}

// The x, y, z of the warped edge points. Adds to @p inserted the number of new ones that are kept.
std::vector<double> warpedEdgePoints(const EdgePoints& edge, const WarpRules& rules, long long& inserted)
{
  Points3 between(static_cast<Eigen::Index>(edge.Positions.size()), 3);
  for (Eigen::Index k = 0; k < between.rows(); ++k)
  {
    between.row(k) = edge.Positions[k];
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
      inserted += edge.Inserted[k];
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
          pointsBetween(this->Input, e, this->Before, this->Rules, this->Counts.Inserted),
          this->Rules,
          this->Counts.Inserted);
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
