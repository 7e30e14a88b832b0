# SPDX-License-Identifier: GPL-3.0-or-later
"""The places at which break_code.py breaks Core: signs, comparisons, constants and omitted steps, in the mathematics
and in the repairs. A break is a file, the text around the place, the expression or statement there, and what replaces
it; a statement that is replaced by nothing is omitted. The text occurs once in the file, the expression once in it.
Conventions and guards against rounding are left out: that their values can be others is what makes them conventions.
"""

import collections

Break = collections.namedtuple("Break", "file text original broken")


def at(file, original, broken, text=None):
    return Break(file, text or original, original, broken)


BREAKS = [
    # --- Base
    at("Base/LaggedCholeskySolver.cxx", "residual -= length * product;", ""),
    at("Base/LaggedCholeskySolver.cxx", "rightSide.dot(solution) >= 0.0", "true"),
    # --- Mesh
    at("Mesh/MeshMeasures.cxx", "3.0 * mesh.faceCount()", "2.0 * mesh.faceCount()"),
    at("Mesh/MeshMeasures.cxx", "std::atan2(u.cross(v).norm(), u.dot(v))", "std::atan2(u.dot(v), u.cross(v).norm())"),
    at("Mesh/MeshMeasures.cxx", "(i + 1) % loop.size()", "std::min(i + 1, loop.size() - 1)"),
    at("Mesh/ClosestPointTree.cxx", "1.0 - weights[1] - weights[2]", "1.0 - weights[1] + weights[2]"),
    at("Mesh/GraphLaplacian.cxx", "-w.Weight", "w.Weight"),
    at("Mesh/GraphLaplacian.cxx", "w.Weight * passed[this->Row[w.From]]", "passed[this->Row[w.From]]"),
    at("Mesh/DerivedMesh.cxx", "derived.Vertices = VertexOrigins(next.Vertices * derived.Vertices);", ""),
    at("Mesh/DerivedMesh.cxx", "derived.Faces[face]", "face"),
    at("Mesh/DerivedMesh.cxx", "share * weight", "weight"),
    at("Mesh/CoordinateFrame.cxx", "this->Origin", "Eigen::Vector3d(0.0, 0.0, 0.0)", "}) + this->Origin;"),
    at("Mesh/CoordinateFrame.cxx", "-this->Exponent", "this->Exponent", "std::ldexp(length, -this->Exponent)"),
    at("Mesh/CoordinateFrame.cxx", "spacing > LargestSpacing * meanEdge", "false"),
    at("Mesh/ClosestPointWalk.cxx", "towards / (towards + beyond)", "beyond / (towards + beyond)"),
    at("Mesh/ClosestPointWalk.cxx", "abToB >= 0.0 && acToB <= abToB", "abToB >= 0.0"),
    at("Mesh/SelfIntersections.cxx", "intersectAtCorner(a, sumOfA, b, sumOfB)", "false"),
    at("Mesh/SelfIntersections.cxx", "CGAL::POSITIVE", "CGAL::NEGATIVE"),
    at("Mesh/MeshTopology.cxx", "count == 2 && side[0].From == side[1].From", "false"),
    at("Mesh/MeshTopology.cxx", "faces[v] != 0", "false"),
    at("Mesh/EditableSurface.cxx", "t * (q - p)", "(1.0 - t) * (q - p)"),
    at("Mesh/EditableSurface.cxx", "1.0 - t", "t", "this->VertexOrigin[source], 1.0 - t"),
    at("Mesh/EditableSurface.cxx", "0.5", "1.0", "return 0.5 * std::sqrt("),
    # --- Intrinsic
    at("Intrinsic/TriangleAngles.cxx", "EIGEN_PI - result.Angle[0] - result.Angle[1]", "EIGEN_PI - result.Angle[0]"),
    at("Intrinsic/TriangleAngles.cxx", "twiceDot[k] / fourArea", "0.5 * twiceDot[k] / fourArea"),
    at("Intrinsic/TriangleAngles.cxx", "l * l + r * r - side[k] * side[k]", "l * l + r * r + side[k] * side[k]"),
    at("Intrinsic/TriangleAngles.cxx", "x * x + y * y - 1.0", "x * x + y * y + 1.0"),
    at("Intrinsic/SymmetricTrapezoid.cxx", "-origin * std::expm1(-ratio)", "origin * std::expm1(-ratio)"),
    at(
        "Intrinsic/SymmetricTrapezoid.cxx",
        "cell.LogAtOrigin + cell.LogAtTip",
        "cell.LogAtOrigin",
        "cell.LogEdge, cell.LogAtOrigin + cell.LogAtTip })",
    ),
    at(
        "Intrinsic/IntrinsicTriangulation.cxx",
        "lengths[next(h)] + lengths[previous(h)] - lengths[h]",
        "lengths[next(h)] + lengths[previous(h)]",
    ),
    at("Intrinsic/IntrinsicDelaunay.cxx", "(p - q) * (p + q)", "(q - p) * (p + q)"),
    at("Intrinsic/IntrinsicDelaunay.cxx", "this->mayFlip(h) && this->Lengths.mustFlip(h)", "false"),
    # --- Geodesics
    at("Geodesics/GeodesicSearch.cxx", "window.Halfedge == window.Earlier", "false"),
    at("Geodesics/GeodesicDistance.cxx", "area / 3.0", "area"),
    at("Geodesics/GeodesicDistance.cxx", "divergence[this->Surface.tip(3 * f + k)] -= flux;", ""),
    at(
        "Geodesics/GeodesicDistance.cxx",
        "values[this->Surface.tip(h)] - values[this->Surface.origin(h)]",
        "values[this->Surface.origin(h)] - values[this->Surface.tip(h)]",
    ),
    at(
        "Geodesics/GeodesicDistance.cxx",
        "(level - a) * (level - a)",
        "(level - a)",
        "areas[f] * (level - a) * (level - a)",
    ),
    at("Geodesics/GeodesicPath.cxx", "1.0 - point.Fraction", "point.Fraction"),
    at("Geodesics/FaceNeighbourhoods.cxx", "radius * radius", "0.25 * radius * radius"),
    # --- Conformal
    at("Conformal/CurvatureSystem.cxx", "EIGEN_PI", "2.0 * EIGEN_PI", "sums[t.tip(h)] = EIGEN_PI"),
    at("Conformal/CurvatureSystem.cxx", "cotangent(h) + (twin >= 0 ? cotangent(twin) : 0.0)", "cotangent(h)"),
    at("Conformal/CurvatureSystem.cxx", "-weight", "weight"),
    at("Conformal/CurvatureSystem.cxx", "this->subtract(t.tipOfBoundaryEdge(b), cell.AngleAtTip);", ""),
    at("Conformal/CotangentWeights.cxx", "cotangents[h] + cotangents[twin]", "cotangents[h] - cotangents[twin]"),
    at("Conformal/MeanValueDisk.cxx", "std::tan(0.5 * angles.Angle[k])", "std::tan(0.25 * angles.Angle[k])"),
    at("Conformal/MeanValueDisk.cxx", "-static_cast<double>(t.logLength(in))", "static_cast<double>(t.logLength(in))"),
    at(
        "Conformal/BoundaryFirstDisk.cxx",
        "u[k] -= 2.0 * std::log(std::abs(1.0 - std::conj(inDisk) * std::polar(1.0, angles[k])));",
        "",
    ),
    at("Conformal/BoundaryFirstDisk.cxx", "exteriorAngles[k]", "-exteriorAngles[k]", "+= exteriorAngles[k]"),
    at(
        "Conformal/BoundaryFirstDisk.cxx",
        "(inHalfPlane - up) / (inHalfPlane + up)",
        "(inHalfPlane + up) / (inHalfPlane - up)",
    ),
    at("Conformal/RicciFlow.cxx", "this->System.addTo(this->Result.LogFactors, step, length);", ""),
    at("Conformal/RicciFlow.cxx", "targetAngles[v] < 1.5 * EIGEN_PI", "false"),
    at("Conformal/RicciFlowDisk.cxx", "-2.0 * spoke.LogLength", "2.0 * spoke.LogLength"),
    at("Conformal/RicciFlowDisk.cxx", "std::log(2.0 * centre.imag())", "std::log(centre.imag())"),
    at("Conformal/HalfPlaneEmbedding.cxx", "EIGEN_PI - angle[v]", "angle[v] - EIGEN_PI"),
    at("Conformal/ConvexCombinationDisk.cxx", "shares / shares.sum()", "shares.reverse().eval() / shares.sum()"),
    at("Conformal/ConformalRectangle.cxx", "0.5 * EIGEN_PI", "0.25 * EIGEN_PI"),
    at("Conformal/ConformalRectangle.cxx", "rectangle.Width / rectangle.Height", "rectangle.Height / rectangle.Width"),
    at("Conformal/DiskNormalisation.cxx", "-std::arg(direction)", "std::arg(direction)"),
    at(
        "Conformal/DiskNormalisation.cxx",
        "(z - centre) / (z - std::conj(centre))",
        "(z - centre) / (z + std::conj(centre))",
    ),
    # --- Untangling
    at(
        "Untangling/FoldoverEnergy.cxx",
        "d * d + 1.0",
        "d * d - 1.0",
        "return (j.squaredNorm() + this->AreaWeight * (d * d + 1.0))",
    ),
    at("Untangling/FoldoverEnergy.cxx", "2.0 * w * d - n * chiByD / chi", "2.0 * w * d + n * chiByD / chi"),
    at("Untangling/FoldoverEnergy.cxx", "-2.0 * chiByD / (chi * chi)", "2.0 * chiByD / (chi * chi)"),
    at("Untangling/VertexUntangling.cxx", "rate > 0.0", "rate < 0.0"),
    at("Untangling/VertexUntangling.cxx", "next.excess(nearest) < 0.0", "next.excess(nearest) > 0.0"),
    at("Untangling/TargetTriangles.cxx", "base2 + left2 - right2", "base2 - left2 + right2"),
    at("Untangling/ConformalFactors.cxx", "0.5", "1.0", "return 0.5 * (flat"),
    # --- Transport
    at("Transport/ArcPolygonMoments.cxx", "0.5 * cross(a, b)", "cross(a, b)"),
    at("Transport/ArcPolygonMoments.cxx", "area / 3.0", "area / 2.0", "this->Moment += area / 3.0 * (a + b);"),
    at("Transport/ArcPolygonMoments.cxx", "angle - std::sin(angle)", "angle + std::sin(angle)"),
    at(
        "Transport/ArcPolygonMoments.cxx",
        "2.0 * sine * sine * sine",
        "2.0 * sine * sine",
        "2.0 * sine * sine * sine / (3.0 * area)",
    ),
    at("Transport/ConvexDomain.cxx", "(1.0 - distance) * (1.0 + distance)", "(1.0 + distance) * (1.0 + distance)"),
    at("Transport/ConvexDomain.cxx", "distance < 0.0 ? distance + this->perimeter() : distance", "std::abs(distance)"),
    at("Transport/ConvexDomain.cxx", "-height / climb", "height / climb"),
    at(
        "Transport/PowerDiagram.cxx",
        "a.squaredNorm() - this->weightDifference(i, j)",
        "a.squaredNorm() + this->weightDifference(i, j)",
    ),
    at(
        "Transport/PowerDiagram.cxx",
        "distance - this->weightDifference(i, j) / distance",
        "distance + this->weightDifference(i, j) / distance",
    ),
    at("Transport/PowerDiagram.cxx", "power(i) < power(site)", "power(site) < power(i)"),
    at("Transport/PowerDiagram.cxx", "this->Domain->addBoundary(side.To, following.From, region);", ""),
    at("Transport/Transport.cxx", "rest[side.Second] += flow;", ""),
    at("Transport/Transport.cxx", "(areas.array() >= least.array()).all()", "true"),
    at("Transport/Transport.cxx", "correction == LargestCorrections", "true"),
    at("Transport/TransportInterpolation.cxx", "map.Slope = spread.inverse() * moments;", ""),
    at("Transport/DomainPolygon.cxx", "convex.area() / EIGEN_PI", "convex.area()"),
    # --- Areas
    at("Areas/FaceAreaEnergy.cxx", "2.0 * w * (r - 1.0)", "w * (r - 1.0)"),
    at("Areas/FaceAreaEnergy.cxx", "s / chiOfQ.Root", "-s / chiOfQ.Root"),
    at(
        "Areas/RefinementEnergy.cxx",
        "0.25 * this->Terms.Cotangents(face, k)",
        "0.5 * this->Terms.Cotangents(face, k)",
    ),
    at("Areas/RefinementEnergy.cxx", "1.0 - 1.0 / rho", "1.0 + 1.0 / rho"),
    at("Areas/RefinementEnergy.cxx", "0.5 * twice", "twice"),
    at(
        "Areas/TargetAreas.cxx",
        "weights[mesh.Faces(f, 0)] + weights[mesh.Faces(f, 1)] + weights[mesh.Faces(f, 2)]",
        "3.0 * weights[mesh.Faces(f, 0)]",
    ),
    at("Areas/TargetAreas.cxx", "GreatestCountFactor", "1.0", ".min(GreatestCountFactor)"),
    at("Areas/DeformationEnergy.cxx", "place - this->Domain->at(parameter)", "this->Domain->at(parameter) - place"),
    at("Areas/SmoothDeformation.cxx", "way - turn * std::round(way / turn)", "way"),
    at("Areas/SmoothDeformation.cxx", "fineness * usual", "usual"),
    at("Areas/MapDeformation.cxx", "faces.row(count++) = gaps.row(gap);", ""),
    at("Areas/DeformationEnergy.cxx", "kept.Point.Stays", "!kept.Point.Stays", "if (kept.Point.Stays)"),
    at("Areas/TargetAreas.cxx", "scaledTargets(faceTargets(surface, {}), targets.sum())", "targets"),
    at("Areas/AreaPreservingDisk.cxx", "range <= std::log(WidestStep)", "true"),
    at("Areas/TargetAreas.cxx", "EIGEN_PI / areas.sum()", "2.0 * EIGEN_PI / areas.sum()"),
    at(
        "Areas/WarmStart.cxx",
        "(1.0 - share) * to[k - 1] + share * to[k]",
        "share * to[k - 1] + (1.0 - share) * to[k]",
    ),
    # --- Repair
    at("Repair/SpikeRemoval.cxx", "sum.norm() / area", "area / sum.norm()"),
    at("Repair/SpikeRemoval.cxx", "intersectionsAfter[i] > intersectionsBefore[i]", "false"),
    at("Repair/SpikeRemoval.cxx", "areaBefore + result.AreaChange < LeastAreaLeft * areaBefore", "false"),
    at("Repair/CoincidentPoints.cxx", "same ? representative[order[i - 1]] : order[i]", "order[i]"),
    at("Repair/CoincidentPoints.cxx", "tolerance", "0.1 * tolerance", "(point, tolerance)"),
    at(
        "Repair/ConsistentOrientation.cxx",
        "closed ? volume < 0.0 : reversedArea > 0.0",
        "closed ? volume > 0.0 : reversedArea > 0.0",
    ),
    at("Repair/ConsistentOrientation.cxx", "faces - reversedFaces", "reversedFaces"),
    at("Repair/TJunctions.cxx", "height > LeastHeightRatio * distance", "true"),
    at("Repair/TJunctions.cxx", "std::replace(rest.begin(), rest.end(), before, middle);", ""),
    at("Repair/NeedlesAndCaps.cxx", "*shortest > slivers::NeedleEdge * *longest", "true"),
    at("Repair/NeedlesAndCaps.cxx", "needles.Faces + caps", "needles.Faces"),
    at("Repair/HoleFilling.cxx", "length > limit", "length < limit"),
    at("Repair/HoleFilling.cxx", "counts[hole] < fewest[hole]", "counts[hole] > fewest[hole]"),
    # --- Remeshing
    at(
        "Remeshing/SelfIntersectionRemoval.cxx",
        "this->intersections(change.After, change, before) < before",
        "this->intersections(change.After, change, before) > before",
    ),
    at(
        "Remeshing/LongestEdgeBisection.cxx",
        "surface.squaredLength(side) <= limit",
        "surface.squaredLength(side) <= 4.0 * limit",
    ),
    at(
        "Remeshing/LongestEdgeBisection.cxx",
        "surface.squaredLength(side) > limit",
        "surface.squaredLength(side) > 4.0 * limit",
    ),
    at(
        "Remeshing/RegionPreservingDecimation.cxx",
        "keep[f.idx()]",
        "false",
        "fixed[surface.edge(h)] || keep[f.idx()]",
    ),
    at("Remeshing/IsotropicRemeshing.cxx", "tangential.norm() < SmallestStep * this->Length", "true"),
    at("Remeshing/SliverRemoval.cxx", "smallestSine(change.After) > Gain * smallestSine(change.Before)", "false"),
    # --- Handles
    at("Handles/HandleRemoval.cxx", "best.Pairs > tolerated", "false"),
    at("Handles/CappedCut.cxx", "step", "-step", "p + step * sum / area"),
    at("Handles/CappedCut.cxx", "std::swap(face[0], face[2]);", ""),
    at("Handles/HalfedgeSurface.cxx", "0.5", "1.0", "this->origin(a), 0.5"),
    # --- Disk
    at("Disk/PlaneCut.cxx", "low >= 0.0", "low <= 0.0"),
    at("Disk/IsolineCut.cxx", "(level - from) / (to - from)", "(level - to) / (from - to)"),
    at("Disk/CutGraph.cxx", "joined.join(from, to);", ""),
    at("Disk/TubeSeam.cxx", "lengths[order[1]] >= LeastEnd * lengths[order[0]]", "true"),
    at(
        "Disk/DiskOpening.cxx",
        "0.5 * (boundaryLength(this->mesh()) - before)",
        "boundaryLength(this->mesh()) - before",
    ),
    at("Disk/SeamSegments.cxx", "start + share * (end - start)", "start"),
    at("Disk/SeamSegments.cxx", "segment = std::min(segment, this->Edges[e].Segment);", ""),
    at("Disk/SeamSegments.cxx", "node->second.IsOnBorder = true;", ""),
    # --- FlatMap
    at("FlatMap/DistortionMeasures.cxx", "alpha + beta", "alpha - beta"),
    at("FlatMap/DistortionMeasures.cxx", "-std::log(result.AreaRatio[f])", "std::log(result.AreaRatio[f])"),
    at("FlatMap/DistortionMeasures.cxx", "orientations[f] <= 0", "orientations[f] < 0"),
    at("FlatMap/DistortionSummary.cxx", "0.02", "0.03", "std::abs(distortion.AreaRatio[f] - 1.0) <= 0.02"),
    at("FlatMap/FlatMapTransfer.cxx", "this->Normals.row(v).dot(this->Walk.normal(at)) > 0.0", "true"),
    at("FlatMap/FlatMapTransfer.cxx", "this->Normals = -this->Normals;", ""),
    at("FlatMap/FlatMapPixels.cxx", "(distance - reach) / pixel", "distance / pixel"),
    at("FlatMap/PlanarWarp.cxx", "place.Distance <= tolerance", "true"),
    # --- Regions
    at("Regions/MeanCurvature.cxx", "n.cross(m).dot(edge)", "m.cross(n).dot(edge)"),
    at("Regions/MeshSaliency.cxx", "v != greatest", "true"),
    at("Regions/MeshSaliency.cxx", "area >= wanted", "area > 2.0 * wanted"),
    at("Regions/RegionWeights.cxx", "(room - asked) / areas.dot(weights.Rest)", "room / areas.dot(weights.Rest)"),
    at("Regions/RegionWeights.cxx", "area > largest", "area < largest", "labels[v] = area > largest ? label"),
]
