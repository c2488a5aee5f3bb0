package org.selectiverenderer.enricher.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.switches.SwitchEdits;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What the document's code says in English about edits and objects, in the window's language. */
@ResourceLock(Resources.LOCALE)
class RemarksTest {
  @TempDir Path folder;
  private final Locale before = Locale.getDefault(Locale.Category.DISPLAY);

  @AfterEach
  void language() {
    Locale.setDefault(Locale.Category.DISPLAY, before);
  }

  private static void greek() {
    Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag("el"));
  }

  private static EditRejectedException refusal(Runnable edit) {
    return catchThrowableOfType(EditRejectedException.class, edit::run);
  }

  @Test
  void refusedEditsAreExplainedInGreek() throws IOException {
    EnricherSession session =
        TestSessions.with(folder, "<Group DEF='A'/>\n<Group DEF='B'/>\n<Shape><Appearance DEF='V'/></Shape>\n");
    NodeEdits nodes = new NodeEdits(session.document());
    DocumentElement a = named(session, "A");
    EditRejectedException taken = refusal(() -> nodes.rename(a, "B"));
    EditRejectedException invalid = refusal(() -> nodes.rename(a, "1 x"));
    EditRejectedException drawn =
        refusal(
            () ->
                new SwitchEdits(session.enrichment(), session.catalogue())
                    .wrap(named(session, "V"), "S"));
    assertThat(Remarks.of(taken)).isEqualTo(taken.getMessage());
    greek();
    assertThat(Remarks.of(taken))
        .isEqualTo("το B είναι ήδη όνομα του Group στη γραμμή 4· διαλέξτε άλλο");
    assertThat(Remarks.of(invalid)).startsWith("το «1 x» δεν είναι έγκυρο όνομα DEF");
    assertThat(Remarks.of(drawn)).startsWith("μόνο κόμβος που σχεδιάζεται μόνος του");
  }

  private static DocumentElement named(EnricherSession session, String name) {
    return session.document().tree().orElseThrow().named(name).orElseThrow();
  }

  /** As the tables of versions list it. */
  @Test
  void aPlaceBeforeARemarkStays() {
    greek();
    assertThat(
            Remarks.shown(
                "scene.x3d:3:5: the object 'VaseA_2' has a Switch already, but not one of Inlines"
                    + " of NAME_v1.x3d, NAME_v2.x3d and so on; it is left as it is"))
        .isEqualTo(
            "scene.x3d:3:5: το αντικείμενο «VaseA_2» έχει ήδη Switch, αλλά όχι με Inline των"
                + " NAME_v1.x3d, NAME_v2.x3d κ.ο.κ.· μένει ως έχει");
  }

  @Test
  void whatIsNoRemarkStays() {
    greek();
    assertThat(Remarks.shown("Έγινε: a {0} 'b'")).isEqualTo("Έγινε: a {0} 'b'");
  }
}
