package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.diff.DiffDialog;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.versions.VersionsDialog;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What the window answers to keys and says after actions. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
class WindowFeedbackTest {
  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;

  private EnricherSession open(String nodes) throws IOException {
    Path scene = TestSessions.with(folder, nodes).file().path();
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(settings.resolve("enricher.properties"), "theme=light\ntab=Help\n");
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    onEdt(() -> window.open(scene));
    hands.await("the scene", () -> window.session().isPresent());
    return window.session().orElseThrow();
  }

  @AfterEach
  void close() {
    onEdt(window::dispose);
  }

  private static void onEdt(Runnable work) {
    GuiRobot.onEdt(
        () -> {
          work.run();
          return true;
        });
  }

  private JLabel status() {
    return GuiRobot.named(window.frame().getContentPane(), "Message", JLabel.class);
  }

  private static DocumentElement named(EnricherSession session, String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  private void type(EnricherSession session, String before, String letters) {
    onEdt(
        () -> {
          int at = session.document().text().toString().indexOf(before);
          session.document().type(at, at, letters);
        });
  }

  @Test
  void aCommandWithControlAndAltTypesNothingIntoAText() throws IOException {
    open(TestSessions.object("Cup"));
    onEdt(() -> window.bench().orElseThrow().showTab(2));
    JTextComponent source =
        GuiRobot.named(
            window.frame().getContentPane(), "Source of the scene", JTextComponent.class);
    hands.click(source);
    String before = GuiRobot.onEdt(source::getText);
    onEdt(
        () -> { // X11 types a control character; Windows, and other layouts, the letter
          int both = InputEvent.CTRL_DOWN_MASK | InputEvent.ALT_DOWN_MASK;
          source.dispatchEvent(
              new KeyEvent(source, KeyEvent.KEY_PRESSED, 0, both, KeyEvent.VK_C, 'c'));
          source.dispatchEvent(
              new KeyEvent(source, KeyEvent.KEY_TYPED, 0, both, KeyEvent.VK_UNDEFINED, 'c'));
        });
    String after = GuiRobot.onEdt(source::getText);
    assertThat(after).isEqualTo(before);
  }

  private Path vrml() throws IOException {
    return Files.writeString(folder.resolve("house.wrl"), "#VRML V2.0 utf8\nGroup { }\n");
  }

  @Test
  void enterConvertsASceneThatIsNotXml() throws IOException {
    open("<Group DEF='Table'/>");
    Path scene = vrml();
    SwingUtilities.invokeLater(() -> window.open(scene));
    JDialog question = hands.dialog(JDialog.class);
    hands.await("the keyboard", question::isFocused);
    hands.press(KeyEvent.VK_ENTER);
    hands.await(
        "the converted scene",
        () -> window.session().filter(now -> now.file().path().endsWith("house.x3d")).isPresent());
    assertThat(folder.resolve("house.x3d")).content().contains("<Group");
  }

  @Test
  void aSceneThatIsNotConvertedIsSaidNotToBeOpen() throws IOException {
    EnricherSession session = open("<Group DEF='Table'/>");
    Path scene = vrml();
    SwingUtilities.invokeLater(() -> window.open(scene));
    hands.choose(hands.dialog(JDialog.class), "Cancel");
    JLabel status = status();
    hands.await("the message", () -> status.getText().startsWith("house.wrl was not opened"));
    assertThat(window.session()).contains(session);
    assertThat(folder.resolve("house.x3d")).doesNotExist();
  }

  @Test
  void anOpeningIsAnnouncedInOnePlace() throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    Path scene = TestSessions.with(folder, "<Group DEF='Table'/>").file().path();
    List<String> said =
        GuiRobot.onEdt(
            () -> {
              window.open(scene);
              return components(window.frame().getContentPane())
                  .filter(JLabel.class::isInstance)
                  .map(each -> ((JLabel) each).getText())
                  .filter(text -> text != null && text.contains("Opening"))
                  .toList();
            });
    assertThat(said).hasSize(1);
    hands.await("the scene", () -> window.session().isPresent());
  }

  @Test
  void enterSavesTheChangesThatAreShown() throws IOException {
    EnricherSession session = open(TestSessions.object("Cup"));
    type(session, "<Switch", "<!-- a cup -->");
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    DiffDialog changes = hands.dialog(DiffDialog.class);
    hands.await("the keyboard", changes::isFocused);
    hands.press(KeyEvent.VK_ENTER);
    hands.await("the file", () -> !session.document().modified());
    assertThat(session.file().path()).content().contains("<!-- a cup -->");
  }

  @Test
  void aMessageIsGoneWithTheNextAction() throws IOException {
    EnricherSession session = open(TestSessions.object("Cup") + "<Group DEF='Table'/>");
    JLabel status = status();
    onEdt(() -> session.message("Done"));
    onEdt(() -> session.select(named(session, "Table"), this));
    assertThat(GuiRobot.onEdt(status::getText)).isEmpty();
    onEdt(() -> session.message("Done"));
    type(session, "<Group", "<!-- a table -->");
    assertThat(GuiRobot.onEdt(status::getText)).isEmpty();
  }

  @Test
  void noProblemsIsSaidOnlyWhenTheChecksHaveEnded() throws IOException {
    EnricherSession session = open("<Group DEF='Table'/>");
    type(session, "version=", "profile='Immersive' ");
    JLabel status = status();
    JLabel count =
        GuiRobot.onEdt(
            () ->
                Stream.of(status.getParent().getComponents())
                    .filter(each -> each != status)
                    .filter(JLabel.class::isInstance)
                    .map(JLabel.class::cast)
                    .findFirst()
                    .orElseThrow());
    hands.await("the checks", () -> count.getText().equals("No problems"));
    String during =
        GuiRobot.onEdt(
            () -> {
              int at = session.document().text().toString().indexOf("<Group");
              session.document().type(at, at, " ");
              return count.getText();
            });
    assertThat(during).isEqualTo("Checking\u2026");
    hands.await("the checks", () -> count.getText().equals("No problems"));
  }

  @Test
  void aSceneWithoutObjectsAndAreasShowsItsNodes() throws IOException {
    open("<Group DEF='Table'/>");
    JComboBox<?> extent =
        GuiRobot.named(
            window.frame().getContentPane(), "Nodes that the tree shows", JComboBox.class);
    String shown = String.valueOf(GuiRobot.onEdt(extent::getSelectedItem));
    assertThat(shown).isEqualTo("Whole scene");
  }

  @Test
  void theVersionsThatWereMadeAreToldAndTheirSwitchIsSelected() throws IOException {
    EnricherSession session =
        open("<Transform DEF='Ball'><Shape><Sphere/></Shape></Transform><Group DEF='Table'/>");
    SwingUtilities.invokeLater(
        () -> {
          session.select(named(session, "Ball"), this);
          JMenuItem make = item("Make Versions...").orElseThrow();
          make.doClick();
        });
    VersionsDialog dialog = hands.dialog(VersionsDialog.class);
    JButton apply = GuiRobot.named(dialog, "Make Versions", JButton.class);
    hands.await("the versions", apply::isEnabled);
    SwingUtilities.invokeLater(apply::doClick);
    hands.await("the end of the dialog", () -> !dialog.isShowing());
    JLabel status = status();
    hands.await("the message", () -> status.getText().contains("2 versions"));
    assertThat(GuiRobot.onEdt(session::selection).map(DocumentElement::name)).contains("Switch");
  }

  @Test
  void aSwitchAroundAnInstanceShowsItsPolygonsAndTakesVersions() throws IOException {
    EnricherSession session =
        open(
            """
            <ProtoDeclare name='Globe'><ProtoBody>
              <Transform><Shape><Sphere/></Shape></Transform>
            </ProtoBody></ProtoDeclare>
            <Transform DEF='Place'><ProtoInstance name='Globe'/></Transform>
            """);
    onEdt(() -> session.select(named(session, "Place").children().get(0), this));
    SwingUtilities.invokeLater(() -> item("Make Switch of Selection...").orElseThrow().doClick());
    JDialog name = hands.dialog(JDialog.class);
    JButton ok = name.getRootPane().getDefaultButton();
    SwingUtilities.invokeLater(ok::doClick);
    hands.await("the end of the question", () -> !name.isShowing());
    hands.await("the Switch", () -> selected(session).equals("Switch Switch_Globe"));
    hands.await("the count", () -> polygons(0).endsWith("polygons"));
    String counted = GuiRobot.onEdt(() -> polygons(0));
    SwingUtilities.invokeLater(() -> item("Make Versions...").orElseThrow().doClick());
    VersionsDialog dialog = hands.dialog(VersionsDialog.class);
    JButton apply = GuiRobot.named(dialog, "Make Versions", JButton.class);
    hands.await("the versions", apply::isEnabled);
    GuiRobot.picture(dialog.getContentPane(), "versions-of-instance", 1);
    SwingUtilities.invokeLater(apply::doClick);
    hands.await("the end of the dialog", () -> !dialog.isShowing());
    JLabel status = status();
    hands.await("the message", () -> status.getText().contains("2 versions"));
    assertThat(GuiRobot.onEdt(() -> session.document().text().toString()))
        .contains("<Transform DEF='Place'><Switch DEF='Switch_Globe' whichChoice='0'>")
        .contains("Globe_v1.x3d", "Globe_v2.x3d")
        .doesNotContain("<ProtoInstance");
    assertThat(counted).isNotEqualTo("0 polygons");
    hands.await("the count of version 1", () -> polygons(0).equals(counted));
    hands.await("the count of version 2", () -> polygons(1).endsWith("polygons"));
    assertThat(GuiRobot.onEdt(() -> polygons(1))).isNotIn(counted, "0 polygons");
  }

  /** Returns what the form says of a choice's polygons; empty if there is no such choice. */
  private String polygons(int choice) {
    return components(window.frame().getContentPane())
        .filter(each -> ("Polygons of choice " + choice).equals(each.getName()))
        .map(each -> ((JLabel) each).getText())
        .findFirst()
        .orElse("");
  }

  private static Stream<Component> components(Container in) {
    return Stream.of(in.getComponents())
        .flatMap(
            each ->
                each instanceof Container more
                    ? Stream.concat(Stream.of(each), components(more))
                    : Stream.of(each));
  }

  private static String selected(EnricherSession session) {
    return session.selection().map(DocumentElement::toString).orElse("");
  }

  private Optional<JMenuItem> item(String text) {
    List<JMenuItem> found = new ArrayList<>();
    for (int i = 0; i < window.frame().getJMenuBar().getMenuCount(); i++) {
      JMenu menu = window.frame().getJMenuBar().getMenu(i);
      for (int k = 0; k < menu.getItemCount(); k++) {
        if (menu.getItem(k) != null && text.equals(menu.getItem(k).getText())) {
          found.add(menu.getItem(k));
        }
      }
    }
    return found.stream().findFirst();
  }
}
