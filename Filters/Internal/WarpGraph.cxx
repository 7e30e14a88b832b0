// SPDX-License-Identifier: GPL-3.0-or-later
#include "Internal/WarpGraph.h"

#include "Core/Base/Errors.h"
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
  Points3 positions(graph->GetNumberOfVertices(), 3);
  for (vtkIdType v = 0; v < positions.rows(); ++v)
  {
    graph->GetPoint(v, positions.row(v).data());
  }
  if (positions.rows() > 1 && (positions.rowwise() - positions.row(0)).isZero(0.0))
  {
    throw InvalidInput("the graph's vertices are all in one place: lay the graph out first");
  }
  return positions;
}

// The edge as a polyline: its two vertices, its own edge points, and new ones where segments are long.
std::vector<Eigen::Vector3d> polylineOf(vtkGraph* graph,
  vtkIdType edge,
  const Points3& vertices,
  const WarpRules& rules,
  CarryCounts& counts)
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
    for (int part = 1; part <= parts; ++part)
    {
      const double share = static_cast<double>(part) / parts;
      line.emplace_back((1.0 - share) * corners[k] + share * corners[k + 1]);
    }
  }
  return line;
}

// x, y, z of the carried points between the ends of an edge.
std::vector<double> carriedEdgePoints(const std::vector<Eigen::Vector3d>& line, const WarpRules& rules)
{
  Points3 between(static_cast<Eigen::Index>(line.size()) - 2, 3);
  for (Eigen::Index k = 0; k < between.rows(); ++k)
  {
    between.row(k) = line[k + 1];
  }
  WarpRules silent = rules;
  silent.Progress = {};
  const CarriedInSpace carried = carryInSpace(between, silent);
  std::vector<double> points;
  for (Eigen::Index k = 0; k < between.rows(); ++k)
  {
    if (carried.Inside[k] || !rules.RemoveOutside)
    {
      const auto* x = carried.Positions.row(k).data();
      points.insert(points.end(), x, x + 3);
    }
  }
  return points;
}

template <typename Builder>
CarryCounts carry(vtkGraph* input, const WarpRules& rules, vtkGraph* output)
{
  CarryCounts counts;
  const Points3 before = positionsOf(input);
  const CarriedInSpace carried = carryInSpace(before, rules);
  requireSomeInside(carried, before);

  vtkNew<Builder> graph;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> surface;
  surface->SetName(SurfacePointsName);
  surface->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> inMap;
  inMap->SetName(InMapName);
  std::vector<vtkIdType> keptAs(before.rows(), -1);
  std::vector<vtkIdType> vertices;
  for (vtkIdType v = 0; v < before.rows(); ++v)
  {
    counts.Outside += carried.Inside[v] == 0;
    if (carried.Inside[v] || !rules.RemoveOutside)
    {
      keptAs[v] = graph->AddVertex();
      vertices.push_back(v);
      points->InsertNextPoint(carried.Positions.row(v).data());
      surface->InsertNextTuple(before.row(v).data());
      inMap->InsertNextValue(carried.Inside[v]);
    }
  }
  graph->SetPoints(points);

  std::vector<vtkIdType> edges;
  for (vtkIdType e = 0; e < input->GetNumberOfEdges(); ++e)
  {
    const vtkIdType source = keptAs[input->GetSourceVertex(e)];
    const vtkIdType target = keptAs[input->GetTargetVertex(e)];
    if (source >= 0 && target >= 0)
    {
      const vtkIdType id = graph->AddEdge(source, target).Id;
      const std::vector<double> between =
        carriedEdgePoints(polylineOf(input, e, before, rules, counts), rules);
      graph->SetEdgePoints(id, static_cast<vtkIdType>(between.size() / 3), between.data());
      edges.push_back(e);
    }
  }

  const auto copyRows =
    [](vtkDataSetAttributes* from, const std::vector<vtkIdType>& rows, vtkDataSetAttributes* to)
  {
    to->CopyAllOn();
    to->CopyAllocate(from, static_cast<vtkIdType>(rows.size()));
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      to->CopyData(from, rows[row], static_cast<vtkIdType>(row));
    }
  };
  copyRows(input->GetVertexData(), vertices, graph->GetVertexData());
  copyRows(input->GetEdgeData(), edges, graph->GetEdgeData());
  graph->GetVertexData()->AddArray(surface);
  graph->GetVertexData()->AddArray(inMap);
  output->CheckedShallowCopy(graph);
  return counts;
}

} // namespace

CarryCounts warpGraph(vtkGraph* input, const WarpRules& rules, vtkGraph* output)
{
  return vtkDirectedGraph::SafeDownCast(input) ? carry<vtkMutableDirectedGraph>(input, rules, output)
                                               : carry<vtkMutableUndirectedGraph>(input, rules, output);
}

} // namespace flattening
