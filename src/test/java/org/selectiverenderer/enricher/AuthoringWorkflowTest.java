package org.selectiverenderer.enricher;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JTable;
import javax.swing.JTextField;
import org.joml.Vector3dc;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.area.AreaInstance;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.cli.Main;
import org.selectiverenderer.enricher.diff.DiffDialog;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.enricher.versions.VersionsDialog;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.GuiRobot;

/**
 * The work of an author who knows no XML, from the thesis's apartment without areas and versions to
 * one that switches as in thesis 5.4, with mouse and keyboard in the window only.
 */
@ShowsWindows
@Timeout(value = 600, unit = TimeUnit.SECONDS)
class AuthoringWorkflowTest {
  private static final Path SCENES = Path.of("scenes");
  private static final Path MODELS = Path.of("inlineNodes");
  private static final List<String> SOFA = List.of("AshTray", "Candle", "Vase");
  private static final List<String> DESK = List.of("TrashCan", "Clock", "FireExtinguisher");
  private static final List<String> BOOKCASE =
      List.of("LibraryMouse", "Mug", "TelephoneLibrary", "LibraryPencilHolder");
  private static final List<String> TEN =
      Stream.of(SOFA, DESK, BOOKCASE).flatMap(List::stream).toList();
  private static final Pattern SWITCH =
      Pattern.compile(
          "<Switch DEF='Switch_(\\w+)' whichChoice='1'>\\s*<Inline [^>]*(url='[^']*')/>"
              + "\\s*<Inline [^>]*/>\\s*</Switch>");

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;

  /** The rooms of the apartment with ten objects in all their polygons; no areas, no versions. */
  private Path apartment() throws IOException {
    Path scenes = Files.createDirectories(folder.resolve("scenes"));
    Path models = Files.createDirectories(folder.resolve("inlineNodes"));
    String text =
        Files.readString(SCENES.resolve("apartment-plain.x3d"))
            .replaceAll(
                "(?s)\n    <Transform DEF='box(Library|Desk|Lounge)'.*?\n    </Transform>", "");
    String flat =
        SWITCH
            .matcher(text)
            .replaceAll(
                found ->
                    TEN.contains(found.group(1))
                        ? "<Inline DEF='%s' %s/>".formatted(found.group(1), found.group(2))
                        : "");
    assertThat(flat).doesNotContain("<Switch").doesNotContain("Sensor");
    Path pictures = Files.createDirectories(models.resolve("textures"));
    try (Stream<Path> all = Files.list(MODELS.resolve("textures"))) {
      for (Path picture : all.toList()) {
        Files.copy(picture, pictures.resolve(picture.getFileName()));
      }
    }
    Matcher url = Pattern.compile("\\.\\./inlineNodes/([^\"]*)").matcher(flat);
    while (url.find()) {
      Path model = models.resolve(url.group(1));
      if (!Files.exists(model)) {
        Files.copy(MODELS.resolve(url.group(1)), model);
      }
    }
    return Files.writeString(scenes.resolve("home.x3d"), flat);
  }

  private EnricherSession open(Path scene) throws IOException {
    Path settings = Files.createDirectories(folder.resolve("settings"));
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    GuiRobot.onEdt(
        () -> {
          window.frame().setSize(1270, 980);
          window.open(scene);
          return true;
        });
    hands.await("the scene", () -> window.session().isPresent());
    return window.session().orElseThrow();
  }

  @AfterEach
  void close() {
    if (window != null) {
      GuiRobot.onEdt(
          () -> {
            window.dispose();
            return true;
          });
    }
  }

  private Container content() {
    return window.frame().getContentPane();
  }

  /** Goes to a text field of the form and replaces what it says. */
  private void fill(String field, String text) {
    hands.click(GuiRobot.named(content(), field, JTextField.class));
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
    hands.write(text);
    hands.press(KeyEvent.VK_ENTER);
  }

  private void choose(String list, int key) {
    hands.click(GuiRobot.named(content(), list, JComboBox.class));
    hands.press(key);
    hands.press(KeyEvent.VK_ENTER);
  }

  /** Searches for the only node of that name. */
  private void find(EnricherSession session, String name) {
    JTextField search = GuiRobot.named(content(), "Search nodes", JTextField.class);
    hands.click(search);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
    hands.write(name);
    hands.press(KeyEvent.VK_ENTER);
    hands.await(
        "the node " + name,
        () ->
            session
                .selection()
                .flatMap(each -> each.def())
                .filter(def -> def.endsWith(name))
                .isPresent());
  }

  private static long colours(JComponent shown) {
    if (shown.getWidth() == 0) {
      return 0;
    }
    int width = shown.getWidth();
    int height = shown.getHeight();
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    shown.paint(image.getGraphics());
    return Arrays.stream(image.getRGB(0, 0, width, height, null, 0, width)).distinct().count();
  }

  private void draw(
      EnricherSession session,
      AreaInstance like,
      double fromX,
      double fromY,
      double toX,
      double toY) {
    JComponent plan = plan();
    hands.drag(plan, fromX, fromY, toX, toY);
    JDialog asks = hands.dialog(JDialog.class);
    JTextField name =
        GuiRobot.named(asks.getContentPane(), Texts.of("area.name"), JTextField.class);
    hands.click(name);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
    hands.write(like.name());
    hands.choose(asks, "OK");
    hands.await(
        "the area",
        () ->
            session
                .selection()
                .flatMap(each -> each.def())
                .filter(like.name()::equals)
                .isPresent());
    place("Centre X", like.box().centre());
    place("Width (X)", like.box().size());
  }

  /** The picture of the plan; its bar is called the same. */
  private JComponent plan() {
    return GuiRobot.onEdt(() -> plan(content()).orElseThrow());
  }

  private static Optional<JComponent> plan(Container in) {
    return Stream.of(in.getComponents()).flatMap(each -> found(each).stream()).findFirst();
  }

  private static Optional<JComponent> found(Component each) {
    boolean picture =
        each.getAccessibleContext() != null
            && each.getAccessibleContext().getAccessibleRole() == AccessibleRole.CANVAS
            && "Plan".equals(each.getName());
    if (picture) {
      return Optional.of((JComponent) each);
    }
    return each instanceof Container more ? plan(more) : Optional.empty();
  }

  /** Writes three numbers, of which Tab goes to the next. */
  private void place(String first, Vector3dc numbers) {
    hands.click(GuiRobot.named(content(), first, JTextField.class));
    for (int axis = 0; axis < 3; axis++) {
      hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_A);
      hands.write("%.3f".formatted(numbers.get(axis)));
      hands.press(KeyEvent.VK_TAB);
    }
  }

  private void makeVersions(EnricherSession session, String object) {
    find(session, "_" + object);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_M);
    VersionsDialog dialog = hands.dialog(VersionsDialog.class);
    hands.await("the versions", GuiRobot.named(dialog, "Make Versions", JButton.class)::isEnabled);
    hands.choose(dialog, "Make Versions");
    assertThat(session.enrichment().switchesByName()).containsKey("Switch_" + object);
  }

  /** The first object by its form, the others by what it says; all show few polygons at first. */
  private void describe(
      EnricherSession session, List<String> objects, String unexpected, String expected) {
    for (String object : objects) {
      find(session, "_" + object);
      if (object.equals(objects.get(0))) {
        choose("Type of choice 0", KeyEvent.VK_I);
        fill("Degree of choice 0", "low");
        fill("Schemas of choice 0", unexpected);
        choose("Type of choice 1", KeyEvent.VK_C);
        fill("Degree of choice 1", "high");
        fill("Schemas of choice 1", expected);
        hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_C);
      } else {
        hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_ALT, KeyEvent.VK_V);
      }
      choose(Texts.of("area.switch.show"), KeyEvent.VK_DOWN);
    }
  }

  private void limit(String state, long polygons) {
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_2);
    JTable table = GuiRobot.named(content(), Texts.of("cost.statesname"), JTable.class);
    hands.await("the counts", () -> row(table, state) >= 0);
    hands.click(table, row(table, state), 6);
    hands.press(KeyEvent.VK_F2);
    hands.write(Long.toString(polygons));
    hands.press(KeyEvent.VK_ENTER);
    hands.await(
        "the limit", () -> String.valueOf(table.getValueAt(row(table, state), 6)).length() > 3);
    String bar =
        GuiRobot.onEdt(
            () -> {
              int row = row(table, state);
              Component cell = table.prepareRenderer(table.getCellRenderer(row, 7), row, 7);
              return cell.getAccessibleContext().getAccessibleName();
            });
    assertThat(bar).contains("left");
  }

  private static int row(JTable table, String state) {
    for (int row = 0; row < table.getRowCount(); row++) {
      if (table.getValueAt(row, 1).equals(state)) {
        return row;
      }
    }
    return -1;
  }

  private static String run(int status, String... args) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    int got =
        Main.execute(args, new PrintStream(out, true, UTF_8), new PrintStream(out, true, UTF_8));
    assertThat(got).as(out.toString(UTF_8)).isEqualTo(status);
    return out.toString(UTF_8);
  }

  /** What happens on a walk to the areas and to the ten objects. */
  private static List<String> happens(Path scene) {
    String all =
        run(
            0,
            "simulate",
            scene.toString(),
            "--path=" + SCENES.resolve("paths").resolve("apartment-tour.csv"));
    Pattern switched = Pattern.compile(" Switch_(\\w+):");
    return all.lines()
        .filter(line -> line.matches(".* (enter|exit|switch) .*"))
        .filter(
            line -> {
              Matcher of = switched.matcher(line);
              return !of.find() || TEN.contains(of.group(1));
            })
        .toList();
  }

  @Test
  void anApartmentIsMadeSelectiveInTheWindowOnly() throws IOException {
    Path scene = apartment();
    EnricherSession session = open(scene);
    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_4);
    Map<String, AreaInstance> areas =
        AreaLocator.of(TestSessions.open(SCENES.resolve("apartment.x3d")).enrichment()).stream()
            .collect(Collectors.toMap(AreaInstance::name, Function.identity()));
    JComponent plan = plan();
    hands.await("the plan", () -> plan.getAccessibleContext().getAccessibleDescription().isEmpty());
    assertThat(GuiRobot.onEdt(() -> colours(plan))).isGreaterThan(50);
    draw(session, areas.get("SofaProx"), 0.1, 0.42, 0.3, 0.58);
    fillArea("SofaSchema", "LoungeSchema");
    draw(session, areas.get("BookcaseProx"), 0.63, 0.42, 0.7, 0.52);
    fillArea("BookcaseSchema", "OfficeSchema");
    draw(session, areas.get("DeskProx"), 0.84, 0.48, 0.9, 0.6);
    fillArea("DeskSchema", "OfficeSchema");
    GuiRobot.picture(window.frame().getRootPane(), "day-areas", 1);

    choose("Nodes that the tree shows", KeyEvent.VK_DOWN);
    TEN.forEach(object -> makeVersions(session, object));
    choose("Nodes that the tree shows", KeyEvent.VK_UP);
    describe(session, SOFA, "SofaSchema", "LoungeSchema");
    describe(session, DESK, "DeskSchema", "OfficeSchema");
    describe(session, BOOKCASE, "BookcaseSchema", "OfficeSchema");
    assertThat(session.enrichment().switches()).hasSize(10).allMatch(each -> each.enriched());
    limit(Texts.of("cost.worst"), 250_000);
    GuiRobot.picture(window.frame().getRootPane(), "day-budget", 1);

    hands.press(KeyEvent.VK_CONTROL, KeyEvent.VK_S);
    hands.choose(hands.dialog(DiffDialog.class), "Save");
    hands.await("the saved file", () -> !session.document().modified());
    Path settings = scene.resolveSibling(".selective-renderer-validate.json");
    assertThat(settings).content().contains("250000");
    String found = run(0, "validate", "--config=" + settings, scene.toString());
    assertThat(found).doesNotContain("warning:").doesNotContain("error:");
    assertThat(happens(scene)).isEqualTo(happens(SCENES.resolve("apartment.x3d")));
  }

  private void fillArea(String enter, String exit) {
    fill("Schemas on entering", enter);
    fill("Schemas on leaving", exit);
  }
}
