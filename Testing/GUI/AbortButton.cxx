// SPDX-License-Identifier: GPL-3.0-or-later
// A library that is loaded into ParaView's process (LD_PRELOAD), and presses its buttons as a user does:
// adds OMT Area Preserving to the active source, presses Apply, presses Abort in the middle of the
// filter's work, and then Apply again. A recorded session cannot do so, because ParaView does not look
// for clicks during a filter's work while one is played.

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QMouseEvent>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <QWindow>

#include <cstdio>
#include <functional>

namespace
{

constexpr int PollMilliseconds = 20;
constexpr int MostMilliseconds = 300'000;
constexpr int WorkBeforeAbortMilliseconds = 300;
constexpr int UntouchedAfterAbortMilliseconds = 1'000;

template <class Type>
Type* named(const char* name)
{
  for (QWidget* window : QApplication::topLevelWidgets())
  {
    if (auto* found = window->findChild<Type*>(name))
    {
      return found;
    }
  }
  return nullptr;
}

void end(const char* problem)
{
  std::fprintf(stderr, "AbortButton: %s\n", problem);
  std::fflush(stdout);
  std::_Exit(1);
}

// Calls next as soon as the condition holds.
void when(const char* awaited, const std::function<bool()>& condition, const std::function<void()>& next)
{
  auto* timer = new QTimer(qApp);
  QElapsedTimer waiting;
  waiting.start();
  QObject::connect(timer,
    &QTimer::timeout,
    qApp,
    [=]
    {
      if (waiting.elapsed() > MostMilliseconds)
      {
        end(awaited);
      }
      if (condition())
      {
        timer->deleteLater();
        timer->stop();
        next();
      }
    });
  timer->start(PollMilliseconds);
}

// As the mouse does: by way of the window.
void click(QWidget* widget)
{
  const QPointF centre = QRectF(widget->rect()).center();
  const QPointF inWindow = widget->mapTo(widget->window(), centre);
  for (const QEvent::Type type : { QEvent::MouseButtonPress, QEvent::MouseButtonRelease })
  {
    const Qt::MouseButtons held = type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton;
    QMouseEvent event(type, inWindow, widget->mapToGlobal(centre), Qt::LeftButton, held, Qt::NoModifier);
    QCoreApplication::sendEvent(widget->window()->windowHandle(), &event);
  }
}

// The button of a toolbar that has an action of this name or text, once it is enabled.
QToolButton* inToolbar(const char* action)
{
  for (QWidget* window : QApplication::topLevelWidgets())
  {
    for (auto* button : window->findChildren<QToolButton*>())
    {
      const QAction* shown = button->defaultAction();
      if (shown && shown->isEnabled() && (shown->objectName() == action || shown->text() == action))
      {
        return button;
      }
    }
  }
  return nullptr;
}

bool isEnabled(const char* button)
{
  const auto* widget = named<QWidget>(button);
  return widget && widget->isEnabled();
}

class Session : public QObject
{
public:
  explicit Session(QObject* parent)
    : QObject(parent)
  {
    // The script that ParaView runs at its start says so when it has made the conformal map.
    when(
      "The filter was not offered for the conformal map.",
      []
      { return qEnvironmentVariableIsSet("CONFORMAL_MAP_IS_MADE") && inToolbar("OMTAreaPreserving"); },
      [this] { this->addFilter(); });
  }

private:
  void addFilter()
  {
    click(inToolbar("OMTAreaPreserving"));
    when(
      "Apply was not enabled.", [] { return isEnabled("Accept"); }, [this] { this->applyAndAbort(); });
  }

  void applyAndAbort()
  {
    this->Applied.start();
    when(
      "Abort was not enabled during the filter's work.",
      [this]
      {
        return this->Returned ||
               (isEnabled("AbortButton") && this->Applied.elapsed() > WorkBeforeAbortMilliseconds);
      },
      [this] { this->abort(); });
    click(named<QWidget>("Accept")); // returns after the filter
    this->Returned = true;
    std::printf("Apply returned %lld ms after Abort\n", static_cast<long long>(this->Aborted.elapsed()));
    QTimer::singleShot(UntouchedAfterAbortMilliseconds, this, [this] { this->applyAgain(); });
  }

  void abort()
  {
    if (this->Returned)
    {
      end("The filter ended before Abort was pressed.");
    }
    std::printf("Abort is pressed at: %s\n", qPrintable(named<QLabel>("ProgressBar")->text()));
    this->Aborted.start();
    click(named<QWidget>("AbortButton"));
  }

  void applyAgain()
  {
    click(inToolbar("Check Aborted"));
    when(
      "Apply was not enabled after the abort.",
      [] { return isEnabled("Accept"); },
      []
      {
        click(named<QWidget>("Accept"));
        click(inToolbar("Check Not Aborted"));
        std::fflush(stdout);
        std::_Exit(0);
      });
  }

  QElapsedTimer Applied;
  QElapsedTimer Aborted;
  bool Returned = false;
};

void startSession()
{
  new Session(qApp);
}

} // namespace

Q_COREAPP_STARTUP_FUNCTION(startSession)
