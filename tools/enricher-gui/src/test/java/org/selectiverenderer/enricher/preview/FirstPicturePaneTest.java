package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** What stands where the picture will be. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class FirstPicturePaneTest {
  @TempDir Path folder;

  @Test
  void itSaysThatTheSceneIsLoadedUntilThereIsAPicture() throws Exception {
    EnricherSession session = TestSessions.with(folder, "<Shape><Box/></Shape>\n");
    List<String> first = new ArrayList<>();
    PreviewPanel[] panel = new PreviewPanel[1];
    GuiRobot.onEdt(
        () -> {
          panel[0] = new PreviewPanel(session);
          return first.add(panel[0].view().waiting().said());
        });
    assertThat(first).containsExactly("Loading the preview\u2026");
    GuiRobot.onEdt(
        () -> {
          panel[0].dispose();
          return true;
        });
    Path file = session.file().path();
    try (PreviewWindowDriver window = new PreviewWindowDriver(file)) {
      window.awaitPicture();
      assertThat(GuiRobot.onEdt(() -> window.panel.view().waiting().isVisible())).isFalse();
    }
  }

  @Test
  void itSaysWhyThereIsNoPicture() throws Exception {
    Path file = Files.writeString(folder.resolve("broken.x3d"), "<X3D>\n<Scene>\n</X3D>\n");
    try (PreviewWindowDriver window = new PreviewWindowDriver(file)) {
      Eventually.await(
          "the reason in the picture",
          () ->
              GuiRobot.onEdt(
                  () ->
                      window.panel.view().waiting().isVisible()
                          && window.panel.view().waiting().said().startsWith("Line 3")));
    }
  }
}
