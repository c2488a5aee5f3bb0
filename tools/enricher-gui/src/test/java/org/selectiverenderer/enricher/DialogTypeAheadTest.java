package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.datatransfer.Clipboard;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.enricher.access.AccessDialog;
import org.selectiverenderer.enricher.importing.PackageDialog;
import org.selectiverenderer.enricher.insert.InsertCommands;
import org.selectiverenderer.enricher.menu.StructureCommands;
import org.selectiverenderer.enricher.newscene.NewSceneDialog;
import org.selectiverenderer.enricher.ratings.RatingsDialog;
import org.selectiverenderer.enricher.robot.FastTypist;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.settings.AllowedPlaces;
import org.selectiverenderer.enricher.versions.BatchVersionsDialog;
import org.selectiverenderer.enricher.versions.VersionsDialog;
import org.selectiverenderer.testing.Eventually;
import org.selectiverenderer.testing.ShowsWindows;

/** Letters that are typed before a dialog is there arrive in its first field. */
@ShowsWindows
@Timeout(value = 240, unit = TimeUnit.SECONDS)
class DialogTypeAheadTest {
  private static final int TIMES = 10;

  @TempDir Path folder;
  private FastTypist typist;

  private enum Kind {
    NEW_SCENE("abcdefghij", "/abcdefghij.x3d"),
    PACKAGE("abcdefghij", "/abcdefghij.zip"),
    ACCESS("abcdefghij", "abcdefghij"),
    RATINGS("abcdefghij", "abcdefghij"),
    VERSIONS("abcdefghij", "abcdefghij"),
    MANY_VERSIONS("1234567", "1234567"),
    INSERT("abcdefghij", "abcdefghij");

    final String typed;
    final String after;

    Kind(String typed, String after) {
      this.typed = typed;
      this.after = after;
    }

    /** Whether a field has all that was typed and nothing else but the folder before it. */
    boolean complete(String text) {
      return after.startsWith("/") ? text.endsWith(after) : text.equals(after);
    }

    /** Opens the dialog as its command does, and waits until it is closed. */
    void open(JFrame owner, EnricherSession session) {
      Path scene = session.file().path();
      switch (this) {
        case NEW_SCENE -> new NewSceneDialog(owner, scene, (over, why) -> false).ask();
        case PACKAGE -> new PackageDialog(owner, scene).ask();
        case ACCESS -> new AccessDialog(owner, scene, AllowedPlaces.NONE).ask();
        case RATINGS -> new RatingsDialog(owner, session).showAndWait();
        case VERSIONS ->
            new VersionsDialog(
                    owner,
                    session,
                    session.document().tree().orElseThrow().named("Vase").orElseThrow())
                .made();
        case MANY_VERSIONS -> new BatchVersionsDialog(owner, session).showAndWait();
        case INSERT ->
            new InsertCommands(
                    session,
                    new StructureCommands(session, new Clipboard("test")),
                    Optional::empty,
                    answer -> answer.accept(Optional.empty()))
                .choose(owner);
      }
    }
  }

  @BeforeEach
  void show() throws AWTException, IOException {
    typist = new FastTypist();
  }

  @AfterEach
  void close() {
    FastTypist.closeDialogs();
    typist.close();
  }

  /** Returns the text that has the keyboard in a dialog; empty if another component has it. */
  private static Optional<String> text() {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner instanceof JTextComponent field
            && SwingUtilities.getWindowAncestor(field) instanceof JDialog
        ? Optional.of(field.getText())
        : Optional.empty();
  }

  @ParameterizedTest
  @EnumSource
  void noLetterTypedWhileADialogOpensIsLost(Kind kind) throws IOException {
    EnricherSession session =
        TestSessions.with(
            folder, "<Transform DEF='Vase'><Shape><Sphere radius='.2'/></Shape></Transform>\n");
    List<String> wrong = new ArrayList<>();
    for (int time = 0; time < TIMES; time++) {
      SwingUtilities.invokeLater(() -> kind.open(typist.window(), session));
      typist.type(kind.typed);
      boolean there =
          Eventually.within(
              10, TimeUnit.SECONDS, () -> get(() -> text().filter(kind::complete).isPresent()));
      if (!there) {
        wrong.add(time + ": " + get(() -> text().orElse("(no text has the keyboard)")));
      }
      FastTypist.closeDialogs();
      typist.goBack();
    }
    assertThat(wrong).as("of " + TIMES + " dialogs").isEmpty();
    String under = get(typist.below()::getText);
    assertThat(under).as("typed into the window below").isEmpty();
  }
}
