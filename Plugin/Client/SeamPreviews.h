// SPDX-License-Identifier: GPL-3.0-or-later
/// The preview of a seam: the line along which it will run, drawn while its points are picked.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <vtkSMProxy.h>
#include <vtkSMSourceProxy.h>
#include <vtkSmartPointer.h>

class pqPipelineSource;
class vtkObject;

/// Draws the geodesics between the Seam Points of a Surface To Disk in the active view, as its panel has
/// them, until Apply has cut the seam.
class SeamPreviews : public QObject
{
public:
  explicit SeamPreviews(QObject* parent);
  ~SeamPreviews() override;

private:
  void watch(pqPipelineSource* source);
  void changed(vtkObject* property, unsigned long event, void* data);
  void update();
  bool create(vtkSMProxy* disk);
  void remove();

  QTimer Later; ///< handles move more often than a geodesic can be found
  QPointer<pqPipelineSource> Edited;
  vtkSmartPointer<vtkSMSourceProxy> Preview;
  vtkSmartPointer<vtkSMProxy> Display;
  vtkSmartPointer<vtkSMProxy> View;
};
