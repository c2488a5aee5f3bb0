package org.selectiverenderer.app.start.window;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.WindowFinder;
import org.selectiverenderer.testing.robot.GuiRobot;

/** The start window, driven as somebody drives it who sees the program for the first time. */
@ShowsWindows
@Timeout(value = 240, unit = TimeUnit.SECONDS)
class StartWindowTest {
  @TempDir Path folder;

  private final GuiRobot hands = new GuiRobot();
  private final CountDownLatch closed = new CountDownLatch(1);

  @BeforeEach
  void look() {
    WindowFinder.closeAll();
    GuiRobot.onEdt(FlatLightLaf::setup);
  }

  @AfterEach
  void endAll() throws Exception {
    WindowFinder.closeAll();
    for (ProcessHandle child : children()) {
      child.destroy();
      child.onExit().get(1, TimeUnit.MINUTES);
    }
  }

  private Path settings() {
    return folder.resolve("settings");
  }

  private JFrame open() {
    GuiRobot.onEdt(
        () -> {
          new StartWindow(settings(), closed::countDown).begin();
          return true;
        });
    return WindowFinder.named(hands, "start");
  }

  private static <C extends Component> C in(Container window, String name, Class<C> type) {
    return GuiRobot.onEdt(() -> find(window, name, type).findFirst().orElseThrow());
  }

  private static <C extends Component> Stream<C> find(
      Container within, String name, Class<C> type) {
    return Stream.of(within.getComponents())
        .flatMap(
            each ->
                type.isInstance(each) && name.equals(each.getName())
                    ? Stream.of(type.cast(each))
                    : each instanceof Container more ? find(more, name, type) : Stream.empty());
  }

  /** The commands that the window has started and that run. */
  private static List<ProcessHandle> children() {
    return ProcessHandle.current().children().toList();
  }

  private JDialog dialog(String name) {
    hands.await("the dialog " + name, () -> !dialogs(name).isEmpty());
    return GuiRobot.onEdt(() -> dialogs(name).get(0));
  }

  private static List<JDialog> dialogs(String name) {
    List<JDialog> shown = new ArrayList<>();
    for (Window each : Window.getWindows()) {
      if (each instanceof JDialog dialog && dialog.isShowing() && name.equals(dialog.getName())) {
        shown.add(dialog);
      }
    }
    return shown;
  }

  @Test
  void anExampleIsCopiedToAFolderOfTheUsersAndShown() throws IOException {
    JFrame window = open();
    assertThat(in(window, "examples.where", JLabel.class).getText()).contains("a folder of yours");
    hands.click(in(window, "show.trash-can", JButton.class));
    JDialog copy = dialog("copy");
    Path target = folder.resolve("my examples");
    JTextField field = in(copy, "copy.folder", JTextField.class);
    assertThat(field.getText()).endsWith("Selective Renderer Examples");
    GuiRobot.onEdt(
        () -> {
          field.setText(target.toString());
          return true;
        });
    hands.press(KeyEvent.VK_ENTER);
    Path scene = target.resolve("scenes/trashcan.x3d");
    hands.await("the viewer", () -> !children().isEmpty());
    assertThat(scene).hasSameTextualContentAs(Path.of("scenes/trashcan.x3d"));
    assertThat(RecentPaths.scenes(settings()).list()).containsExactly(scene);
    JLabel where = in(window, "examples.where", JLabel.class);
    hands.await("the place of the examples", () -> where.getText().contains("my examples"));
    assertThat(in(window, "said", JTextArea.class).getText()).contains("trashcan.x3d");
  }

  @Test
  void whoDoesNotWantTheExamplesGetsNone() {
    JFrame window = open();
    hands.click(in(window, "edit.apartment", JButton.class));
    JDialog copy = dialog("copy");
    hands.press(KeyEvent.VK_ESCAPE);
    hands.await("the end of the dialog", () -> !copy.isShowing());
    assertThat(children()).isEmpty();
    assertThat(settings().resolve("example-folders")).doesNotExist();
  }

  @Test
  void whatACommandSaysIsShownWhereItFails() throws IOException {
    Path broken = Files.writeString(folder.resolve("broken.x3d"), "no scene at all");
    RecentPaths.scenes(settings()).add(broken);
    JFrame window = open();
    JList<?> recent = in(window, "recent", JList.class);
    hands.await("the list", () -> recent.getModel().getSize() == 1);
    assertThat(recent.getModel().getElementAt(0).toString()).contains("Scene", "broken.x3d");
    hands.click(recent);
    hands.press(KeyEvent.VK_ENTER);
    JTextArea said = in(window, "said", JTextArea.class);
    hands.await("the failure", () -> said.getText().contains("broken.x3d:"));
  }

  @Test
  void theMachineIsCheckedInAWindow() {
    JFrame window = open();
    hands.click(in(window, "doctor", JButton.class));
    JDialog doctor = dialog("doctor");
    JLabel state = in(doctor, "doctor.state", JLabel.class);
    hands.await("the findings", () -> state.getText().startsWith("Done"));
    assertThat(in(doctor, "doctor.text", JTextArea.class).getText()).contains("Java", "OpenGL");
    hands.press(KeyEvent.VK_ESCAPE);
    hands.await("the end of the dialog", () -> !doctor.isShowing());
  }

  @Test
  void everyControlHasANameAndTheKeyboardReachesAll() {
    JFrame window = open();
    for (String name :
        List.of("open", "enrich", "studies", "doctor", "show.sculptures", "edit.apartment")) {
      JButton button = in(window, name, JButton.class);
      assertThat(button.getAccessibleContext().getAccessibleName()).isNotBlank();
      assertThat(button.isFocusable()).isTrue();
    }
    JButton open = in(window, "open", JButton.class);
    hands.await("the focus", open::isFocusOwner);
    assertThat(window.getRootPane().getDefaultButton()).isSameAs(open);
    WindowFinder.close(window);
    hands.await("the end", () -> closed.getCount() == 0);
  }
}
