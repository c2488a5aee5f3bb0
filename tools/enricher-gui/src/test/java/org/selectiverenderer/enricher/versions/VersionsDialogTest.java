package org.selectiverenderer.enricher.versions;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/** Versions of an object are made by hand: a slider, a look, one step, undone. */
@ShowsWindows
class VersionsDialogTest {
  private static final String BALL =
      "  <Transform DEF='Ball'>\n    <Shape><Sphere/></Shape>\n  </Transform>\n";

  @TempDir Path folder;

  @Test
  void theSliderSaysHowManyVerticesAndTheStepMakesTheVersions() throws IOException {
    TestSessions.theme(false);
    EnricherSession session = TestSessions.with(folder, BALL);
    String before = session.document().text().toString();
    GuiRobot hands = new GuiRobot();
    VersionsDialog dialog =
        GuiRobot.onEdt(
            () ->
                new VersionsDialog(
                    null,
                    session,
                    session.document().tree().orElseThrow().named("Ball").orElseThrow()));
    hands.show(dialog);
    JButton make = GuiRobot.named(dialog, "Make Versions", JButton.class);
    hands.await("the first result", make::isEnabled);
    int original = polygons(dialog, 1);
    int half = polygons(dialog, 2);
    assertThat(half).isBetween(original / 3, 2 * original / 3);

    JSlider slider = GuiRobot.named(dialog, "Vertices of version 2", JSlider.class);
    GuiRobot.onEdt(slider::requestFocusInWindow);
    hands.await("the focus", slider::isFocusOwner);
    hands.press(KeyEvent.VK_PAGE_DOWN);
    hands.press(KeyEvent.VK_PAGE_DOWN);
    hands.await("fewer percent", () -> slider.getValue() < 40);
    hands.await("the second result", make::isEnabled);
    assertThat(polygons(dialog, 2)).isLessThan(half);

    JComponent picture =
        GuiRobot.named(dialog, "Picture of version 2, wireframe", JComponent.class);
    hands.click(picture);
    hands.await("the focus on the picture", picture::isFocusOwner);
    hands.press(KeyEvent.VK_LEFT);
    GuiRobot.picture(dialog.getContentPane(), "versions-ball", 1);

    hands.click(GuiRobot.named(dialog, "Add Version", JButton.class));
    hands.await("the third version", make::isEnabled);
    assertThat(polygons(dialog, 3)).isLessThan(polygons(dialog, 2));
    GuiRobot.picture(dialog.getContentPane(), "versions-three", 1);
    hands.click(make);
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(folder.resolve("inlineNodes/Ball_v3.x3d")).exists();
    assertThat(session.enrichment().switches()).hasSize(1);
    assertThat(session.document().history().names()).containsExactly("Make versions of Ball");
    session.document().history().undo();
    assertThat(session.document().text().toString()).isEqualTo(before);
    assertThat(folder.resolve("inlineNodes")).as("undone with its files").doesNotExist();
    session.document().history().redo();
    assertThat(folder.resolve("inlineNodes/Ball_v3.x3d")).exists();
  }

  @Test
  void versionsThatAreThereAreShownAndStay() throws IOException {
    TestSessions.theme(false);
    String byHand = "<X3D version='4.0'><Scene><Shape><Box/></Shape></Scene></X3D>";
    Files.writeString(folder.resolve("Ball_v1.x3d"), byHand.replace("Box", "Sphere"));
    Path second = Files.writeString(folder.resolve("Ball_v2.x3d"), byHand);
    EnricherSession session =
        TestSessions.with(
            folder,
            "<Switch DEF='Ball'><Inline url='\"Ball_v1.x3d\"'/><Inline url='\"Ball_v2.x3d\"'/>"
                + "</Switch>");
    GuiRobot hands = new GuiRobot();
    VersionsDialog dialog =
        GuiRobot.onEdt(
            () ->
                new VersionsDialog(
                    null,
                    session,
                    session.document().tree().orElseThrow().named("Ball").orElseThrow()));
    hands.show(dialog);
    JComboBox<?> goal = GuiRobot.named(dialog, "Goal of version 2", JComboBox.class);
    hands.await("what is there", () -> goal.getSelectedItem() == VersionGoal.Kind.KEEP);
    JButton make = GuiRobot.named(dialog, "Make Versions", JButton.class);
    assertThat(GuiRobot.onEdt(make::isEnabled)).as("nothing to make").isFalse();
    assertThat(polygons(dialog, 2)).isEqualTo(12);
    GuiRobot.onEdt(
        () -> {
          goal.setSelectedItem(VersionGoal.Kind.PERCENT);
          return null;
        });
    JTextField name = GuiRobot.named(dialog, Texts.of("versions.name.described"), JTextField.class);
    GuiRobot.onEdt(
        () -> {
          name.setText("Round");
          return null;
        });
    hands.await("another version", make::isEnabled);
    GuiRobot.picture(dialog.getContentPane(), "versions-kept", 1);
    hands.click(make);
    hands.await("the end", () -> !dialog.isShowing());
    assertThat(second).hasContent(byHand);
    assertThat(session.document().text().toString()).contains("Round_v2.x3d");
    session.document().history().undo();
    assertThat(folder.resolve("Round_v2.x3d")).doesNotExist();
  }

  private static int polygons(VersionsDialog dialog, int version) {
    JLabel label = GuiRobot.named(dialog, "Polygons of version " + version, JLabel.class);
    return Integer.parseInt(GuiRobot.onEdt(label::getText).replace(",", ""));
  }
}
