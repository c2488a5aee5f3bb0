package org.selectiverenderer.enricher.insert;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JFileChooser;
import org.joml.AxisAngle4d;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.area.LocalCoordinateSystem;
import org.selectiverenderer.authoring.structure.NodeTemplate;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.enricher.component.FileUrl;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.menu.StructureCommands;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** The commands that insert templates and nodes at the selection. */
public final class InsertCommands {
  /** The templates in the order of the menu; an empty name stands for a separator. */
  public static final List<String> TEMPLATES =
      List.of(
          "box",
          "sphere",
          "cylinder",
          "cone",
          "wall",
          "text",
          "group",
          "",
          "lamp",
          "spot",
          "sun",
          "view",
          "sky",
          "",
          "inline");

  /** The fields of templates that say where they are. */
  private static final List<String> PLACED =
      List.of("Transform translation", "PointLight location", "SpotLight location");

  private static final double EYE = 1.6;
  private static final double AHEAD = 3;
  private static final int DECIMALS = 3;

  private final EnricherSession session;
  private final StructureCommands structure;
  private final Supplier<Optional<Pose>> viewer;
  private final Ground ground;
  private Consumer<DocumentElement> onInserted = element -> {};

  /** Answers a place before the viewer on which an object can stand; empty where none is known. */
  @FunctionalInterface
  public interface Ground {
    void ahead(Consumer<Optional<Vector3d>> answer);
  }

  /**
   * @param viewer where the preview's viewer is; empty while there is none
   */
  public InsertCommands(
      EnricherSession session,
      StructureCommands structure,
      Supplier<Optional<Pose>> viewer,
      Ground ground) {
    this.session = session;
    this.structure = structure;
    this.viewer = viewer;
    this.ground = ground;
  }

  /** Sets what is done with a node that was inserted, which may be a while after the command. */
  public void onInserted(Consumer<DocumentElement> listener) {
    onInserted = listener;
  }

  /** Asks for a node that may go where the selection is, and inserts it. */
  public void choose(Component over) {
    if (session.document().tree().isEmpty()) {
      session.message(Texts.of("node.formsWait"));
      return;
    }
    Optional<DocumentElement> goal = selected();
    InsertDialog dialog = new InsertDialog(structure.palette(), goal);
    dialog.ask(over).ifPresent(name -> insert(name, goal, over));
  }

  private Optional<DocumentElement> selected() {
    return session.selection().filter(DocumentElement::attached);
  }

  /**
   * Inserts a template or a node where the selection is now.
   *
   * @param name the name of a template, or of a node type
   * @param over the component over which a file is asked for
   */
  public void insert(String name, Component over) {
    insert(name, selected(), over);
  }

  private void insert(String name, Optional<DocumentElement> goal, Component over) {
    NodeTemplate template = structure.palette().template(name);
    switch (name) {
      case "inline" -> file(over).ifPresent(file -> place(goal, () -> inlined(template, file)));
      case "view" ->
          put(goal, viewer.get().map(pose -> at(template, pose)).orElse(template));
      default -> place(goal, () -> template);
    }
  }

  /**
   * Inserts a template before the viewer: what stands, on what is there, not inside of it. The
   * place is known later; what was asked for goes to what was selected then, in the scene as it has
   * become.
   *
   * @param goal empty for the end of the scene
   */
  private void place(Optional<DocumentElement> goal, Supplier<NodeTemplate> made) {
    NodeTemplate template = made.get();
    Optional<Matrix4d> fromScene = hasPlace(template) ? fromScene(goal, template) : Optional.empty();
    if (fromScene.isEmpty()) {
      put(goal, template);
      return;
    }
    long revision = session.document().revision();
    ground.ahead(
        found -> {
          if (gone(goal)) {
            session.message(Texts.of("insert.gone", goal.orElseThrow()));
          } else if (revision == session.document().revision()) {
            Vector3d at = found.map(place -> under(template, place)).orElseGet(this::inFront);
            put(goal, shifted(template, fromScene.get().transformPosition(at)));
          } else {
            place(goal, made); // its name may be taken now, its place covered
          }
        });
  }

  private static boolean gone(Optional<DocumentElement> goal) {
    return goal.isPresent() && !goal.get().attached();
  }

  private static boolean hasPlace(NodeTemplate template) {
    return PLACED.stream().anyMatch(field -> template.text().startsWith("<" + field.split(" ")[0]));
  }

  /** Returns the floor that a light hangs over: not a table before the viewer, but what is below. */
  private Vector3d under(NodeTemplate template, Vector3d ground) {
    Optional<Pose> pose = viewer.get();
    if (template.text().startsWith("<Transform") || pose.isEmpty()) {
      return ground;
    }
    double floor = pose.get().position().y() - eyeHeight();
    return new Vector3d(ground.x, Math.min(ground.y, floor), ground.z);
  }

  private void put(Optional<DocumentElement> goal, NodeTemplate template) {
    if (structure.insert(goal, template)) {
      session.selection().ifPresent(onInserted);
    }
  }

  /**
   * Returns the transformation from the scene to the node that a template gets into; empty where
   * the text does not tell it.
   */
  private Optional<Matrix4d> fromScene(Optional<DocumentElement> goal, NodeTemplate template) {
    try {
      return LocalCoordinateSystem.within(structure.palette().parent(goal, template))
          .map(system -> system.world().invert(new Matrix4d()));
    } catch (EditRejectedException e) {
      return Optional.of(new Matrix4d()); // said when it is inserted
    }
  }

  private Optional<Path> file(Component over) {
    Path folder = session.file().path().toAbsolutePath().getParent();
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setCurrentDirectory(folder == null ? null : folder.toFile());
    chooser.setDialogTitle(Texts.of("insert.inline.title"));
    return chooser.showOpenDialog(over) == JFileChooser.APPROVE_OPTION
        ? Optional.of(chooser.chosen())
        : Optional.empty();
  }

  /** Returns the template of an Inline with the url and the name of a file. */
  NodeTemplate inlined(NodeTemplate template, Path file) {
    String url = FileUrl.of(session.file().path(), file);
    String name = String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
    NodeTemplate placed = template.with("Inline", "url", FieldValueFormatter.strings(url));
    return placed.with("Transform", "DEF", structure.free(name.isBlank() ? "Model" : name));
  }

  private static NodeTemplate at(NodeTemplate template, Pose pose) {
    AxisAngle4d turn = new AxisAngle4d().set(pose.orientation());
    boolean turned = Math.abs(turn.angle) > 1e-6;
    NodeTemplate placed =
        template.with(
            "Viewpoint",
            "position",
            numbers(pose.position().x(), pose.position().y(), pose.position().z()));
    return turned
        ? placed.with("Viewpoint", "orientation", numbers(turn.x, turn.y, turn.z, turn.angle))
        : placed;
  }

  private static String numbers(double... of) {
    StringBuilder text = new StringBuilder();
    for (double each : of) {
      text.append(text.isEmpty() ? "" : " ").append(DecimalFormatter.rounded(each, DECIMALS));
    }
    return text.toString();
  }

  /** Returns the ground under the eyes before the viewer, without asking for what is there. */
  private Vector3d inFront() {
    Optional<Pose> pose = viewer.get();
    if (pose.isEmpty()) {
      return new Vector3d();
    }
    Vector3d ahead = pose.get().orientation().transform(new Vector3d(0, 0, -1));
    ahead.y = 0;
    if (ahead.lengthSquared() < 1e-6) {
      ahead.set(0, 0, -1);
    }
    ahead.normalize(AHEAD).add(pose.get().position());
    ahead.y = pose.get().position().y() - eyeHeight();
    return ahead;
  }

  private static NodeTemplate shifted(NodeTemplate template, Vector3dc by) {
    NodeTemplate placed = template;
    for (String field : PLACED) {
      String[] words = field.split(" ");
      placed = placed.shifted(words[0], words[1], new double[] {by.x(), by.y(), by.z()}, DECIMALS);
    }
    return placed;
  }

  private double eyeHeight() {
    return session.document().tree().stream()
        .flatMap(tree -> tree.scene().stream())
        .flatMap(scene -> scene.children().stream())
        .filter(each -> each.name().equals("NavigationInfo"))
        .flatMap(each -> each.text("avatarSize").stream())
        .map(text -> text.strip().split("[\\s,]+"))
        .filter(words -> words.length > 1)
        .flatMap(words -> number(words[1]).stream())
        .findFirst()
        .orElse(EYE);
  }

  private static Optional<Double> number(String word) {
    try {
      return Optional.of(Double.parseDouble(word)).filter(Double::isFinite);
    } catch (NumberFormatException e) {
      return Optional.empty(); // a fault that the validator reports
    }
  }
}
