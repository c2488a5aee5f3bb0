package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.JTree;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.driving.Hands;
import org.selectiverenderer.enricher.driving.Sessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What a window is like that is worked in for an hour. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class WindowFeelTest {
  @TempDir Path folder;
  private final Hands hands = new Hands();
  private EnricherWindow window;

  @AfterEach
  void close() {
    Hands.onEdt(
        () -> {
          window.dispose();
          return true;
        });
  }

  private Path scene() throws IOException {
    return Sessions.with(
            folder,
            "<Group DEF='Table'>"
                + Sessions.object("Cup")
                + "</Group>"
                + Sessions.object("Chair")
                + Sessions.object("Armchair"))
        .file()
        .path();
  }

  private void show() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Help\n");
    window = Hands.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
  }

  private EnricherSession open(Path scene) {
    Optional<EnricherSession> before = window.session();
    Hands.onEdt(
        () -> {
          window.open(scene);
          return true;
        });
    hands.await(
        "the scene", () -> window.session().isPresent() && !window.session().equals(before));
    return window.session().orElseThrow();
  }

  @Test
  void openingIsSaidAtOnceAndAFileThatCannotBeOpenedLeavesTheWelcome() throws IOException {
    show();
    JLabel welcome =
        Hands.named(
            window.frame().getContentPane(),
            "Drop an X3D scene here, or press Ctrl+O to open one",
            JLabel.class);
    Path scene = scene();
    String said =
        Hands.onEdt(
            () -> {
              window.open(scene);
              return welcome.getText();
            });
    assertThat(said).isEqualTo("Opening scene.x3d\u2026");
    hands.await("the scene", () -> window.session().isPresent());
  }

  @Test
  void theFormKeepsItsWidthHoweverManyScenesAreOpened() throws IOException {
    show();
    Path scene = scene();
    open(scene);
    int before = formWidth();
    for (int i = 0; i < 3; i++) {
      open(scene);
    }
    assertThat(formWidth()).isEqualTo(before);
  }

  private int formWidth() {
    JComponent form =
        Hands.named(window.frame().getContentPane(), "Form of the selected node", JComponent.class);
    return Hands.onEdt(form::getWidth);
  }

  @Test
  void enterGoesFromHitToHitAndAProblemInAHiddenNodeShowsIt() throws IOException {
    show();
    EnricherSession session = open(scene());
    JTextField search =
        Hands.named(window.frame().getContentPane(), "Search nodes", JTextField.class);
    JTree tree = Hands.named(window.frame().getContentPane(), "Nodes of the scene", JTree.class);
    hands.click(search);
    "CHAIR".chars().forEach(hands::press);
    hands.press(KeyEvent.VK_ENTER);
    assertThat(selected(session)).contains("Switch_Chair");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(selected(session)).contains("Switch_Armchair");
    hands.press(KeyEvent.VK_ENTER);
    assertThat(selected(session)).as("again from the first").contains("Switch_Chair");
    assertThat(Hands.onEdt(search::isFocusOwner)).isTrue();
    Hands.onEdt(
        () -> {
          search.setText("cup");
          search.postActionEvent();
          return true;
        });
    assertThat(selected(session)).contains("Switch_Cup");
    hands.await("the tree, which has the only hit", tree::isFocusOwner);
    Hands.onEdt(
        () -> {
          var document = session.document();
          int at = document.text().toString().indexOf("DEF='Table'");
          document.type(at, at, "bboxSize='wide' ");
          return true;
        });
    hands.await(
        "the problem",
        () -> {
          window.bench().orElseThrow().nextProblem();
          return session.selection().flatMap(DocumentElement::def).equals(Optional.of("Table"));
        });
    assertThat(Hands.onEdt(tree::getLastSelectedPathComponent))
        .isSameAs(session.selection().orElseThrow());
    String searched = Hands.onEdt(search::getText);
    assertThat(searched).isEmpty();
  }

  private static Optional<String> selected(EnricherSession session) {
    return Hands.onEdt(() -> session.selection().flatMap(DocumentElement::def));
  }
}
