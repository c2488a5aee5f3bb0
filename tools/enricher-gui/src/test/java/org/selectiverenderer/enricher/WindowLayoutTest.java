package org.selectiverenderer.enricher;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What a window of the usual size has room for, in both languages. */
@ShowsWindows
@Timeout(value = 180, unit = TimeUnit.SECONDS)
@ResourceLock(Resources.LOCALE)
class WindowLayoutTest {
  private static final int WIDTH = 1280;
  private static final int HEIGHT = 860;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private final Locale before = Locale.getDefault(Locale.Category.DISPLAY);
  private EnricherWindow window;
  private String nodes = "";

  @BeforeEach
  void nodes() {
    StringBuilder all = new StringBuilder("<Group/>\n<Transform>\n<Shape/>\n</Transform>\n");
    all.append(
        """
        <Transform DEF='Hall' translation='1 0 0'>
          <ProximitySensor DEF='HallArea' size='4 3 4'/>
        </Transform>
        <ProximitySensor DEF='DeskArea' size='2 2 2'/>
        """);
    for (int i = 0; i < 30; i++) {
      all.append(TestSessions.object("Object" + i));
    }
    nodes = all.toString();
  }

  @AfterEach
  void close() {
    GuiRobot.onEdt(
        () -> {
          window.dispose();
          return true;
        });
    Locale.setDefault(Locale.Category.DISPLAY, before);
  }

  private EnricherSession open(String language) throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    Files.writeString(
        settings.resolve("enricher.properties"),
        "theme=light%nlanguage=%s%nwindow.x=0%nwindow.y=0%nwindow.width=%d%nwindow.height=%d%n"
            .formatted(language, WIDTH, HEIGHT));
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    Path scene = TestSessions.with(folder, nodes).file().path();
    GuiRobot.onEdt(
        () -> {
          window.open(scene);
          return true;
        });
    hands.await("the scene", () -> window.session().isPresent());
    return window.session().orElseThrow();
  }

  private Workbench bench() {
    return window.bench().orElseThrow();
  }

  private void validate() {
    GuiRobot.onEdt(
        () -> {
          window.frame().validate();
          return true;
        });
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "el"})
  void noTextIsCutOffWithoutATooltipAndNoneStandsInANarrowColumn(String language)
      throws IOException {
    EnricherSession session = open(language);
    List<String> cut = new ArrayList<>();
    List<DocumentElement> elements = new ArrayList<>();
    for (String def : List.of("HallArea", "DeskArea", "Hall", "Switch_Object1")) {
      elements.add(session.document().tree().orElseThrow().named(def).orElseThrow());
    }
    DocumentElement scene = session.document().tree().orElseThrow().scene().orElseThrow();
    elements.add(scene.children().get(0));
    elements.add(scene.children().get(1));
    int tabs = GuiRobot.onEdt(() -> tabs().getTabCount());
    for (DocumentElement element : elements) {
      GuiRobot.onEdt(
          () -> {
            session.select(element, this);
            return true;
          });
      for (int tab = 0; tab < tabs; tab++) {
        int index = tab;
        GuiRobot.onEdt(
            () -> {
              bench().showTab(index);
              return true;
            });
        validate();
        validate(); // a wrapped text knows its height once it has a width
        cut.addAll(
            GuiRobot.onEdt(
                () ->
                    ClippedTexts.in(window.frame().getRootPane()).stream()
                        .map(text -> element + ", " + tabs().getTitleAt(index) + ": " + text)
                        .toList()));
      }
      GuiRobot.picture(
          window.frame().getRootPane(), "layout-" + language + "-" + element.name(), 1);
    }
    assertThat(cut).isEmpty();
  }

  /** Of the smallest screens. */
  @Test
  void inASmallWindowFindingsLeaveRoomForTheFormAndNoButtonIsCutOff() throws IOException {
    EnricherSession session = open("el");
    GuiRobot.onEdt(
        () -> {
          window.frame().setSize(800, 600);
          session.select(
              session.document().tree().orElseThrow().named("Switch_Object1").orElseThrow(), this);
          return true;
        });
    hands.await("the small window", () -> window.frame().getContentPane().getWidth() < 801);
    validate();
    validate();
    GuiRobot.picture(window.frame().getRootPane(), "layout-small", 1);
    JComponent form = GuiRobot.named(window.frame(), Texts.of("form.panel"), JComponent.class);
    JComponent findings =
        GuiRobot.named(window.frame(), Texts.of("keep.findings"), JComponent.class);
    String unwrap = MnemonicText.of(Texts.of("area.switch.unwrap")).words();
    JButton button = GuiRobot.named(window.frame(), unwrap, JButton.class);
    GuiRobot.onEdt(
        () -> {
          assertThat(findings.getHeight()).isLessThanOrEqualTo(form.getHeight() / 3);
          assertThat(button.getX() + button.getWidth())
              .isLessThanOrEqualTo(button.getParent().getWidth());
          assertThat(button.getWidth()).isGreaterThanOrEqualTo(button.getPreferredSize().width);
          assertThat(button.getY() + button.getHeight())
              .isLessThanOrEqualTo(button.getParent().getHeight());
          return true;
        });
  }

  private JTabbedPane tabs() {
    return find(window.frame().getRootPane(), JTabbedPane.class).orElseThrow();
  }

  private static <T> Optional<T> find(java.awt.Container in, Class<T> type) {
    for (java.awt.Component each : in.getComponents()) {
      if (type.isInstance(each)) {
        return Optional.of(type.cast(each));
      }
      Optional<T> within =
          each instanceof java.awt.Container more ? find(more, type) : Optional.empty();
      if (within.isPresent()) {
        return within;
      }
    }
    return Optional.empty();
  }

  @Test
  void theFirstSelectionDoesNotMoveThePicture() throws IOException {
    EnricherSession session = open("en");
    validate();
    Rectangle before = picture();
    GuiRobot.onEdt(
        () -> {
          session.select(
              session.document().tree().orElseThrow().named("Switch_Object1").orElseThrow(), this);
          return true;
        });
    validate();
    assertThat(picture()).isEqualTo(before);
  }

  private Rectangle picture() {
    return GuiRobot.onEdt(
        () ->
            SwingUtilities.convertRectangle(
                tabs().getParent(), tabs().getBounds(), window.frame().getRootPane()));
  }

  @Test
  void theTableOfSchemasShowsTenObjectsAndTheCostsBelowOpenByAClick() throws IOException {
    open("en");
    GuiRobot.onEdt(
        () -> {
          bench().showTab(1);
          return true;
        });
    validate();
    JTable table = GuiRobot.named(window.frame(), "Degrees of objects by schemas", JTable.class);
    // Without a schema the table has no width of its own; what shows it has its height.
    int rows = GuiRobot.onEdt(() -> table.getParent().getHeight() / table.getRowHeight());
    assertThat(rows).isGreaterThanOrEqualTo(10);
    AbstractButton title =
        GuiRobot.named(window.frame(), "Polygons and limits", AbstractButton.class);
    hands.click(title);
    JPanel costs = GuiRobot.named(window.frame(), "Polygons and limits", JPanel.class);
    hands.await("the costs", costs::isShowing);
    hands.click(title);
    hands.await("the table alone", () -> !costs.isShowing());
  }
}
