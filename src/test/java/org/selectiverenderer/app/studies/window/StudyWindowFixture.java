package org.selectiverenderer.app.studies.window;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.JTabbedPane;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.RequiresDisplay;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

/** A study window with settings of its own. */
@RequiresDisplay
abstract class StudyWindowFixture {
  @TempDir Path folder;

  final GuiRobot hands = new GuiRobot();
  final CountDownLatch closed = new CountDownLatch(1);

  @BeforeEach
  void look() {
    WindowFinder.closeAll();
    GuiRobot.onEdt(FlatLightLaf::setup);
  }

  @AfterEach
  void closeAll() {
    WindowFinder.closeAll();
  }

  /** Opens the window. */
  JFrame open(Optional<Path> study) {
    GuiRobot.onEdt(
        () -> {
          new StudyWindow(folder.resolve("settings"), closed::countDown).begin(study);
          return true;
        });
    return WindowFinder.named(hands, "studies");
  }

  /** Opens the window with a study, and waits until that is shown. */
  JFrame open(Path study, String title) {
    JFrame window = open(Optional.of(study));
    hands.await("the study", () -> window.getTitle().startsWith(title));
    return window;
  }

  /** Returns the component of a name. */
  static <C extends Component> C in(Container window, String name, Class<C> type) {
    return GuiRobot.onEdt(
        () -> {
          C found = find(window, name, type);
          if (found == null) {
            throw new AssertionError("no component has the name " + name);
          }
          return found;
        });
  }

  private static <C extends Component> @Nullable C find(
      Container within, String name, Class<C> type) {
    for (Component each : within.getComponents()) {
      if (type.isInstance(each) && name.equals(each.getName())) {
        return type.cast(each);
      }
      C found = each instanceof Container more ? find(more, name, type) : null;
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  /** Shows a page. */
  void page(JFrame window, int index) {
    JTabbedPane tabs = in(window, "tabs", JTabbedPane.class);
    GuiRobot.onEdt(
        () -> {
          tabs.setSelectedIndex(index);
          return true;
        });
  }
}
