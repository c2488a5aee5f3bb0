package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.enricher.compare.CompareMode;
import org.selectiverenderer.enricher.cost.BudgetFileLocator;
import org.selectiverenderer.enricher.preview.PreviewImageProbe;
import org.selectiverenderer.enricher.preview.PreviewPanel;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.testing.robot.DisplaySettling;
import org.selectiverenderer.testing.robot.GuiRobot;

/**
 * Takes the manual's pictures of the enricher's window: {@code docs/pictures.sh} runs it, the suite
 * does not. Each is written to {@code target/pictures} when the window rests, with what the table
 * says: theme, size, view, what is selected. {@code -Dpictures=a,b} takes only these.
 */
@ShowsWindows
class EnricherPictures {
  private static final Path APARTMENT = Path.of("scenes/apartment.x3d");
  private static final int PREVIEW = 0;
  private static final int SCHEMAS = 1;
  private static final int SOURCE = 2;
  private static final int PLAN = 3;
  private static final int HELP = 4;

  /** A window is looked at so often, and so far apart, until it has not changed in between. */
  private static final int LOOKS = 200;

  private static final int BETWEEN_MS = 1500;

  @TempDir Path folder;
  private final GuiRobot hands = new GuiRobot();
  private EnricherWindow window;
  private String name = "";

  /** More of the window's settings, of the picture that shows limits. */
  private String limits = "";

  @TestFactory
  Stream<DynamicTest> pictures() {
    Map<String, Executable> all = new LinkedHashMap<>();
    all.put("enricher-preview", () -> whole("LIGHT", PREVIEW, "Switch_TrashCan"));
    all.put("enricher-dark", () -> whole("DARK", PREVIEW, "Switch_TrashCan"));
    all.put("enricher-schemas", () -> whole("LIGHT", SCHEMAS, "Switch_TrashCan"));
    all.put("enricher-source", () -> whole("LIGHT", SOURCE, "Switch_TrashCan"));
    all.put("enricher-help", () -> whole("LIGHT", HELP, "Switch_TrashCan"));
    all.put("enricher-areas", () -> whole("LIGHT", PLAN, "DeskProx"));
    all.put("enricher-plan", this::plan);
    all.put("enricher-find", this::find);
    all.put("enricher-fault", this::fault);
    all.put("enricher-switch", this::form);
    all.put("enricher-qualities", this::qualities);
    all.put("enricher-cost", this::cost);
    all.put("enricher-compare", this::compare);
    all.put("enricher-handles", this::handles);
    List<String> wanted = List.of(System.getProperty("pictures", "").split(","));
    return all.entrySet().stream()
        .filter(each -> wanted.equals(List.of("")) || wanted.contains(each.getKey()))
        .map(each -> DynamicTest.dynamicTest(each.getKey(), () -> take(each)));
  }

  private void take(Map.Entry<String, Executable> picture) throws Throwable {
    name = picture.getKey();
    limits = "";
    try {
      picture.getValue().execute();
    } finally {
      close();
    }
  }

  private EnricherSession open(String theme, int width, int height, Path scene) throws IOException {
    Path settings = Files.createDirectories(folder.resolve(name));
    Files.writeString(
        settings.resolve("enricher.properties"),
        "theme=%s%nlanguage=en%nwindow.x=0%nwindow.y=0%nwindow.width=%d%nwindow.height=%d%n%s%n"
            .formatted(theme, width, height, limits));
    window = GuiRobot.onEdt(() -> new EnricherWindow(settings, () -> {}));
    hands.show(window.frame());
    edt(() -> window.open(scene));
    hands.await("the scene", () -> window.session().isPresent());
    return window.session().orElseThrow();
  }

  /** Limits of which one is broken, in a file of their own for the scenes of the repository. */
  private String limits() throws IOException {
    Path file = folder.resolve(BudgetFileLocator.NAME);
    Files.writeString(
        file,
        """
        {"budgets": [
          {"scope": "Kitchen", "polygons": 60000},
          {"scope": "Office", "schemas": ["DeskSchema"], "polygons": 70000},
          {"polygons": 300000}
        ]}
        """);
    Properties chosen = new Properties();
    chosen.setProperty(
        "validate-settings " + APARTMENT.toAbsolutePath().normalize().getParent(), file.toString());
    StringWriter text = new StringWriter();
    chosen.store(text, null);
    return text.toString();
  }

  private static void edt(Runnable work) {
    EventThread.edt(work);
  }

  private void select(String def) {
    EnricherSession session = window.session().orElseThrow();
    edt(
        () ->
            session.select(session.document().tree().orElseThrow().named(def).orElseThrow(), this));
  }

  private Workbench bench() {
    return window.bench().orElseThrow();
  }

  private void tab(int index) {
    edt(() -> bench().showTab(index));
  }

  private Container content() {
    return window.frame().getRootPane();
  }

  private <T extends Component> T part(String called, Class<T> type) {
    return GuiRobot.named(content(), called, type);
  }

  /** Paints a part of the window when it does not change any more. */
  private void write(Container part) {
    hands.await("all counts of versions", () -> !waits(part));
    int[] before = {};
    for (int look = 0; look < LOOKS; look++) {
      int[] now = GuiRobot.onEdt(() -> pixels(part));
      if (Arrays.equals(before, now)) {
        GuiRobot.picture(part, name, 2);
        return;
      }
      before = now;
      DisplaySettling.pause(BETWEEN_MS);
    }
    throw new AssertionError(name + ": the window does not come to rest");
  }

  /** Whether something in it is still to be counted. */
  private static boolean waits(Container in) {
    return Stream.of(in.getComponents())
        .anyMatch(
            each ->
                each instanceof JLabel label && "\u2026".equals(label.getText())
                    || each instanceof Container more && waits(more));
  }

  private static int[] pixels(Container part) {
    BufferedImage image =
        new BufferedImage(part.getWidth(), part.getHeight(), BufferedImage.TYPE_INT_RGB);
    part.paint(image.getGraphics());
    return image.getRGB(0, 0, part.getWidth(), part.getHeight(), null, 0, part.getWidth());
  }

  private void whole(String theme, int tab, String selected) throws IOException {
    open(theme, 1280, 860, APARTMENT);
    drawn();
    select(selected);
    await(part("Preview", PreviewPanel.class));
    tab(tab);
    write(content());
  }

  /** Waits until the preview shows what is selected, at the size that the window now leaves it. */
  private void await(PreviewPanel preview) {
    hands.await(
        "the picture of the selected node",
        () -> PreviewImageProbe.selected(preview) && PreviewImageProbe.fits(preview));
  }

  /** Waits for the first picture of the preview, from which the plan is made, too. */
  private void drawn() {
    tab(PREVIEW);
    hands.await("the preview", () -> bench().drawnBy().isPresent() && bench().here().isPresent());
  }

  private void plan() throws IOException {
    EnricherSession session = open("LIGHT", 1280, 800, APARTMENT);
    drawn();
    select("DeskProx"); // So that the plan fits beside the form.
    tab(PLAN);
    BoundingBox kitchen = new BoundingBox(-1.9f, -1.946f, -2.9f, 1.9f, 0.75f, 2.6f);
    SwingUtilities.invokeLater(() -> bench().areas().add(AreaBox.of(kitchen)));
    hands.dialog(JDialog.class);
    hands.write("KitchenArea");
    hands.press(KeyEvent.VK_ENTER);
    hands.await("the area", () -> session.enrichment().sensorsByName().containsKey("KitchenArea"));
    write(content());
  }

  private void find() throws IOException {
    open("LIGHT", 1200, 748, APARTMENT);
    tab(SOURCE);
    edt(() -> bench().inSource(source -> source.find(true)));
    hands.write("translation");
    hands.press(KeyEvent.VK_ENTER);
    write(content());
  }

  private void fault() throws IOException {
    Path broken = Path.of("target/pictures/broken.x3d"); // The window says where it is.
    Files.createDirectories(broken.getParent());
    Files.writeString(broken, "<X3D>\n<Scene>\n<Group>\n</Scene>\n</X3D>\n");
    open("LIGHT", 1280, 800, broken);
    write(content());
  }

  private void form() throws IOException {
    open("LIGHT", 1280, 1000, APARTMENT);
    drawn();
    select("Switch_Selotape");
    write(part("Form of the selected node", JPanel.class));
  }

  private void qualities() throws IOException {
    open("LIGHT", 1280, 1190, Path.of("docs/examples/qualities/jug.x3d"));
    drawn();
    select("Switch_Jug");
    JPanel form = part("Form of the selected node", JPanel.class);
    JComponent versions = part("Versions differ in", JComponent.class);
    edt(
        () -> {
          JComponent list = (JComponent) versions.getParent();
          list.scrollRectToVisible(new Rectangle(0, 0, 1, form.getHeight()));
        });
    write(form);
  }

  private void cost() throws IOException {
    limits = limits();
    open("LIGHT", 1590, 1190, APARTMENT);
    tab(SCHEMAS);
    JTable states = part("Polygons by area and schemas", JTable.class);
    hands.await("the count", () -> states.getRowCount() > 0);
    edt(
        () -> {
          states.setRowSelectionInterval(10, 10);
          states.scrollRectToVisible(states.getCellRect(10, 0, true));
        });
    write(part("Polygons and limits", JPanel.class));
  }

  private void compare() throws IOException {
    open("LIGHT", 1500, 860, APARTMENT);
    drawn();
    PreviewPanel preview = part("Preview", PreviewPanel.class);
    edt(
        () -> {
          preview.asIf(List.of("KitchenSchema"));
          preview.compare(CompareMode.WIPE);
        });
    hands.await("both pictures", () -> PreviewImageProbe.comparedAsIf(preview));
    write(preview);
  }

  private void handles() throws IOException {
    open("LIGHT", 1280, 800, APARTMENT);
    drawn();
    PreviewPanel preview = part("Preview", PreviewPanel.class);
    select("DeskProx");
    await(preview);
    AbstractButton frame = part("Bring the selected object into view (F)", AbstractButton.class);
    edt(frame::doClick);
    write(preview);
  }

  @AfterEach
  void close() {
    if (window != null) {
      edt(window::dispose);
      window = null;
    }
  }
}
