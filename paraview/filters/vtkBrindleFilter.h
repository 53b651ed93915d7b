/// The common part of Brindle's filters: surface, waves and pattern, cached between runs.
#pragma once

#include <functional>
#include <memory>

#include <vtkPolyDataAlgorithm.h>

#include "BrindleFiltersModule.h"  // export macro

/// Takes polygons, or the surface of grids and blocks, and lays waves over it. Input array 0 is the
/// field, array 1 the frequency, array 2 weights, of points or cells. The ranks of VTK's global
/// controller share one surface and run together.
class BRINDLEFILTERS_EXPORT vtkBrindleFilter : public vtkPolyDataAlgorithm {
 public:
  vtkTypeMacro(vtkBrindleFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The source of directions, in the order of FieldSource: 0 smooth, 1 curvature, 2 direction, 3
  /// array.
  vtkSetClampMacro(Field, int, 0, 3);
  vtkGetMacro(Field, int);
  /// For curvature fields, 0: larger, 1: smaller absolute curvature.
  vtkSetClampMacro(CurvatureDirection, int, 0, 1);
  vtkGetMacro(CurvatureDirection, int);
  /// For arrays of tensors, in the order of TensorAxis: 0 major, 1 minor, 2 largest absolute, 3 and
  /// 4 major and minor of the tangential part.
  vtkSetClampMacro(TensorAxis, int, 0, 4);
  vtkGetMacro(TensorAxis, int);
  /// The order of a tensor's components: 0 VTK's (6 or 9 numbers), 1 Voigt's (6), 2 of the x-y
  /// plane (3 or 4).
  vtkSetClampMacro(TensorOrder, int, 0, 2);
  vtkGetMacro(TensorOrder, int);
  /// For direction fields: any vector but zero.
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  /// Whether stripes run along the field instead of across it.
  vtkSetMacro(Along, bool);
  vtkGetMacro(Along, bool);
  /// Smooths an array over this many periods of the stripes and fills holes; 0 to 100, 0: none.
  /// Input array 2, if set, has the weights of the data.
  vtkSetMacro(FieldSmoothing, double);
  vtkGetMacro(FieldSmoothing, double);
  /// The same for an array of frequencies.
  vtkSetMacro(FrequencySmoothing, double);
  vtkGetMacro(FrequencySmoothing, double);
  /// With FieldSmoothing: temporal smoothing, the weight of the last time's field; 0 or above.
  vtkSetMacro(TemporalSmoothing, double);
  vtkGetMacro(TemporalSmoothing, double);
  /// With FieldSmoothing and FrequencySmoothing: distance over which holes are filled, in periods;
  /// 0 or above.
  vtkSetMacro(FillPeriods, double);
  vtkGetMacro(FillPeriods, double);
  /// With FieldSmoothing: vectors have signs, and opposite ones cancel.
  vtkSetMacro(FieldArrows, bool);
  vtkGetMacro(FieldArrows, bool);
  /// With FieldSmoothing: cancels pairs of singularities until at most this many remain; -1: none.
  vtkSetClampMacro(FieldSingularities, int, -1, 1000000);
  vtkGetMacro(FieldSingularities, int);
  /// Turns the field about the normals, in degrees.
  vtkSetMacro(Rotate, double);
  vtkGetMacro(Rotate, double);

  /// Bend, in degrees, from which edges are creases with separate stripes per side: 0 to 180, 180:
  /// none. Several ranks have none.
  vtkSetMacro(CreaseAngle, double);
  vtkGetMacro(CreaseAngle, double);

  /// The source of frequencies, in the order of FrequencySource: 0 Stripes, 1 Frequency, 2 an
  /// array, 3 Stripes times a factor that follows an array, 4 Spacing.
  vtkSetClampMacro(FrequencySource, int, 0, 4);
  vtkGetMacro(FrequencySource, int);
  /// Stripes along the diagonal of the bounding box; above 0.
  vtkSetMacro(Stripes, double);
  vtkGetMacro(Stripes, double);
  /// Stripes per unit length; above 0.
  vtkSetMacro(Frequency, double);
  vtkGetMacro(Frequency, double);
  /// Distance between neighbouring stripes; above 0.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  /// Factors at the smallest and the largest number of the array.
  vtkSetVector2Macro(FrequencyRange, double);
  vtkGetVector2Macro(FrequencyRange, double);
  /// Spacing tolerance, for fewer branches; 0 or above.
  vtkSetMacro(Slack, double);
  vtkGetMacro(Slack, double);
  /// Weight of the last time's pattern; 0: none.
  vtkSetMacro(TimeAnchor, double);
  vtkGetMacro(TimeAnchor, double);

  /// The numbers of derived surfaces, built solvers, and patterns that continued the last time's.
  int GetSurfacesMade() const;
  int GetSolversMade() const;
  int GetPatternsFollowed() const;
  /// Milliseconds to solve the last pattern.
  double GetSolveMilliseconds() const;

  vtkBrindleFilter(const vtkBrindleFilter&) = delete;
  void operator=(const vtkBrindleFilter&) = delete;

 protected:
  /// Input of `Fill` in the library's types.
  struct Run;

  vtkBrindleFilter();
  ~vtkBrindleFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

  /// Makes the output of a run. Collective: an error on one rank is thrown on all. May throw
  /// brindle::Error; the output is then emptied.
  virtual void Fill(Run& run, vtkPolyData* output) = 0;

 private:
  struct State;

  bool Prepare(vtkDataObject* input, Run& run);
  void Fail(vtkPolyData* output, const char* message);
  void EndIfOthersWait(const Run& run);
  void WarnOf(const Run& run);

  int Field = 0;
  int CurvatureDirection = 0;
  int TensorAxis = 0;
  int TensorOrder = 0;
  double Direction[3] = {0, 0, 1};
  bool Along = false;
  double FieldSmoothing = 0;
  double FillPeriods = 2;
  double FrequencySmoothing = 0;
  double TemporalSmoothing = 0;
  bool FieldArrows = false;
  int FieldSingularities = -1;
  double Rotate = 0;
  double CreaseAngle = 40;
  int FrequencySource = 0;
  double Stripes = 40;
  double Frequency = 1;
  double Spacing = 1;
  double FrequencyRange[2] = {0.4, 2.5};
  double Slack = 0;
  double TimeAnchor = 0.025;
  bool Stopped = false;  // the last run was aborted
  std::unique_ptr<State> Internals;
};
