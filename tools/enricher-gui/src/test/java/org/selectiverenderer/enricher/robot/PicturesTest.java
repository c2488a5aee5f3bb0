package org.selectiverenderer.enricher.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JTable;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher;
import org.selectiverenderer.authoring.ratings.RatingPlan;
import org.selectiverenderer.authoring.ratings.RatingScale;
import org.selectiverenderer.authoring.ratings.Ratings;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.enricher.diff.DiffDialog;
import org.selectiverenderer.enricher.overview.OverviewPanel;
import org.selectiverenderer.enricher.ratings.RatingsDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.versions.VersionsDialog;
import org.selectiverenderer.study.gaze.GazeSimulator;
import org.selectiverenderer.study.gaze.GazeSimulator.Target;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/**
 * The dialogs with the apartment, light and dark, at both scales. Their pictures in {@code
 * target/pictures} are for looking at, and for the manual.
 */
@ShowsWindows
class PicturesTest {
  private static final Path SCENES = Path.of("scenes");
  private static final Path RATINGS = SCENES.resolve("apartment-ratings.csv");

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();

  /**
   * At both scales: of the theme's brightness, with words on it, the larger one no blown up one.
   */
  private static void both(Container content, String name, boolean dark) {
    String theme = dark ? "-dark" : "-light";
    BufferedImage plain = GuiRobot.picture(content, name + theme, 1);
    BufferedImage fine = GuiRobot.picture(content, name + theme + "-200", 2);
    for (BufferedImage each : List.of(plain, fine)) {
      double[] brightness = brightness(each).toArray();
      double mean = Arrays.stream(brightness).average().orElseThrow();
      assertThat(mean).as("brightness of 255").isBetween(dark ? 20.0 : 160.0, dark ? 110.0 : 254.0);
      double most = Arrays.stream(brightness).map(value -> Math.abs(value - mean)).max().orElse(0);
      assertThat(most).as("words that can be read").isGreaterThan(80);
    }
    assertThat(fine.getWidth()).isEqualTo(2 * plain.getWidth());
    assertThat(blownUp(fine)).isFalse();
  }

  private static DoubleStream brightness(BufferedImage image) {
    int[] pixels =
        image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    return Arrays.stream(pixels)
        .mapToDouble(rgb -> ((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255)) / 3.0);
  }

  /** Whether each block of two by two pixels has one colour. */
  private static boolean blownUp(BufferedImage image) {
    for (int y = 0; y + 1 < image.getHeight(); y += 2) {
      for (int x = 0; x + 1 < image.getWidth(); x += 2) {
        int rgb = image.getRGB(x, y);
        if (image.getRGB(x + 1, y) != rgb || image.getRGB(x, y + 1) != rgb) {
          return false;
        }
      }
    }
    return true;
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void overview(boolean dark) throws IOException {
    TestSessions.theme(dark);
    EnricherSession session = TestSessions.open(SCENES.resolve("apartment.x3d"));
    JFrame frame =
        GuiRobot.onEdt(
            () -> {
              JFrame made = new JFrame();
              made.setContentPane(new OverviewPanel(session));
              made.setSize(1000, 640);
              return made;
            });
    hands.show(frame);
    JTable table = GuiRobot.named(frame, "Degrees of objects by schemas", JTable.class);
    hands.click(table, 3, 1);
    assertThat(GuiRobot.onEdt(table::getRowCount)).isGreaterThan(20);
    both(frame.getContentPane(), "overview", dark);
    GuiRobot.onEdt(
        () -> {
          frame.dispose();
          return true;
        });
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void ratings(boolean dark) throws IOException {
    TestSessions.theme(dark);
    EnricherSession session = TestSessions.open(SCENES.resolve("apartment-plain.x3d"));
    RatingsDialog dialog = GuiRobot.onEdt(() -> new RatingsDialog(null, session));
    hands.show(dialog);
    GuiRobot.onEdt(
        () -> {
          dialog.open(RATINGS);
          return true;
        });
    hands.await("the plan", GuiRobot.named(dialog, "Apply", JButton.class)::isEnabled);
    both(dialog.getContentPane(), "ratings", dark);
    GuiRobot.onEdt(
        () -> {
          dialog.dispose();
          return true;
        });
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void gaze(boolean dark) throws IOException {
    TestSessions.theme(dark);
    EnricherSession session = TestSessions.open(SCENES.resolve("apartment-plain.x3d"));
    byte[] table = Files.readAllBytes(RATINGS);
    Ratings ratings = Ratings.read("ratings.csv", table, new ProblemCollector()).orElseThrow();
    List<String> names = new ArrayList<>();
    List<Double> attention = new ArrayList<>();
    new ObjectNameMatcher(ratings.means().keySet(), session.enrichment().switches())
        .matches()
        .forEach(
            match -> {
              Ratings.Mean mean = ratings.means().get(match.object()).get("OfficeSchema");
              if (mean != null) {
                names.add(match.switchName().orElseThrow());
                attention.add((3.8 - mean.value()) / 2);
              }
            });
    List<Target> targets = new ArrayList<>();
    double[] all = attention.stream().mapToDouble(each -> each).toArray();
    for (Target each : GazeSimulator.along(all, 1)) {
      targets.add(new Target(names.get(targets.size()), each.box(), each.attention()));
    }
    List<String> schemas = List.of("OfficeSchema");
    GazeSimulator room = new GazeSimulator("apartment-plain.x3d", schemas, targets);
    for (int p = 1; p <= 16; p++) {
      Path log = folder.resolve("study/sub-%03d/ses-01/head/a_run-01.csv".formatted(p));
      GazeSimulator.write(room.log(90, p), log);
    }
    RatingsDialog dialog = GuiRobot.onEdt(() -> new RatingsDialog(null, session));
    hands.show(dialog);
    GuiRobot.onEdt(
        () -> {
          dialog.open(RATINGS);
          return true;
        });
    hands.await("the plan", GuiRobot.named(dialog, "Apply", JButton.class)::isEnabled);
    GuiRobot.onEdt(
        () -> {
          dialog.openLogs(List.of(folder.resolve("study")));
          return true;
        });
    JTable proposals =
        GuiRobot.named(dialog, "Proposals from what participants looked at", JTable.class);
    hands.await("the proposals", proposals::isShowing);
    GuiRobot.onEdt(
        () -> {
          proposals.setValueAt(true, 0, 0);
          proposals.setValueAt(true, 1, 0);
          return true;
        });
    both(dialog.getContentPane(), "gaze", dark);
    GuiRobot.onEdt(
        () -> {
          dialog.dispose();
          return true;
        });
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void versions(boolean dark) throws IOException {
    TestSessions.theme(dark);
    EnricherSession session = TestSessions.open(SCENES.resolve("apartment.x3d"));
    var object = session.enrichment().switchesByName().get("Switch_TrashCan").element();
    VersionsDialog dialog = GuiRobot.onEdt(() -> new VersionsDialog(null, session, object));
    hands.show(dialog);
    JComboBox<?> goal = GuiRobot.named(dialog, "Goal of version 2", JComboBox.class);
    hands.await(
        "the versions", () -> "Keep as It Is".equals(String.valueOf(goal.getSelectedItem())));
    both(dialog.getContentPane(), "versions", dark);
    GuiRobot.onEdt(
        () -> {
          dialog.dispose();
          return true;
        });
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void diff(boolean dark) throws IOException {
    TestSessions.theme(dark);
    Path scene = Files.copy(SCENES.resolve("apartment-plain.x3d"), folder.resolve("plain.x3d"));
    EnricherSession session = TestSessions.open(scene);
    byte[] table = Files.readString(RATINGS).getBytes(StandardCharsets.UTF_8);
    Ratings ratings = Ratings.read("ratings.csv", table, new ProblemCollector()).orElseThrow();
    var matching = new ObjectNameMatcher(ratings.means().keySet(), session.enrichment().switches());
    session.perform(
        RatingPlan.of(session.enrichment(), ratings, matching, true, RatingScale.BANDS)
            .edit("Import ratings"));
    DiffDialog dialog = GuiRobot.onEdt(() -> new DiffDialog(null, session));
    hands.show(dialog);
    JList<?> lines = GuiRobot.named(dialog, "Changes of the file", JList.class);
    hands.await("the lines", () -> lines.getModel().getSize() > 100);
    both(dialog.getContentPane(), "diff", dark);
    hands.press(java.awt.event.KeyEvent.VK_F3);
    assertThat(List.of(GuiRobot.onEdt(lines::getSelectedIndex))).doesNotContain(-1);
    GuiRobot.onEdt(
        () -> {
          dialog.dispose();
          return true;
        });
  }
}
