package org.selectiverenderer.authoring.area;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.structure.NeededComponents;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates edits that add, move and copy the areas of a document. Each edit is for the document's
 * present state and is performed by {@link SceneDocument#perform}; an edit that would change
 * nothing is empty. All throw {@link EditRejectedException} with a sentence for the author where an
 * edit cannot be made.
 */
public final class AreaEdits {
  private static final List<String> STATEMENTS = List.of("ROUTE", "IMPORT", "EXPORT");
  private static final double SAME = 1e-6;

  private final SceneDocument document;
  private final DocumentEnrichment enrichment;
  private final NodeEdits nodes;
  private final NeededComponents components;

  /** Creates edits for a document with nodes of a catalogue. */
  public AreaEdits(DocumentEnrichment enrichment, NodeCatalogue catalogue) {
    this.enrichment = enrichment;
    this.document = enrichment.document();
    this.components = new NeededComponents(document, catalogue);
    this.nodes = new NodeEdits(document);
  }

  /**
   * Adds an area: a ProximitySensor in scene coordinates, after the existing areas.
   *
   * @param name its unused DEF name
   */
  public Edit add(String name, AreaBox box) {
    sound(box);
    nodes.check(name);
    DocumentElement scene = scene();
    SourceFormatter layout = document.layout();
    char quote = layout.quote(scene.children().isEmpty() ? scene : scene.children().get(0));
    String line =
        "<ProximitySensor"
            + SourceFormatter.written("DEF", name, quote)
            + SourceFormatter.written("center", text(box.centre(), new float[3], box.size()), quote)
            + SourceFormatter.written("size", text(box.size(), new float[3], box.size()), quote)
            + "/>";
    List<TextEdit> changes = new ArrayList<>(components.of(Set.of("ProximitySensor")));
    changes.add(inserted(scene, line));
    return new Edit("Add the area " + name, changes);
  }

  /** Returns the element to which areas are added: the Scene, or its active Layer. */
  private DocumentElement scene() {
    DocumentElement scene =
        document
            .tree()
            .orElseThrow(this::broken)
            .scene()
            .orElseThrow(
                () -> new EditRejectedException("the file has no Scene, so no area can be added"));
    for (DocumentElement set : scene.children()) {
      if (set.name().equals("LayerSet")) {
        return activeLayer(set).orElse(scene);
      }
    }
    return scene;
  }

  private EditRejectedException broken() {
    return new EditRejectedException(
        document
                .fault()
                .map(fault -> fault.location() + ": " + fault.message())
                .orElse(document.name())
            + "; correct it in the source view first");
  }

  private static Optional<DocumentElement> activeLayer(DocumentElement set) {
    String active = set.text("activeLayer").orElse("0").strip();
    List<DocumentElement> layers =
        set.children().stream()
            .filter(child -> child.name().toLowerCase(Locale.ROOT).endsWith("layer"))
            .toList();
    for (int i = 0; i < layers.size(); i++) {
      if (String.valueOf(i + 1).equals(active) && layers.get(i).name().equals("Layer")) {
        return Optional.of(layers.get(i));
      }
    }
    return Optional.empty();
  }

  /**
   * Inserts a line after the last child that contains an area, else after all nodes and before the
   * routes.
   */
  private TextEdit inserted(DocumentElement scene, String line) {
    SourceFormatter layout = document.layout();
    Optional<DocumentElement> after = Optional.empty();
    for (DocumentElement child : scene.children()) {
      if (holdsArea(child)) {
        after = Optional.of(child);
      }
    }
    if (after.isEmpty()) {
      after =
          scene.children().stream()
              .filter(child -> !STATEMENTS.contains(child.name()))
              .reduce((one, other) -> other);
    }
    return after
        .map(child -> layout.insertAfter(child, List.of(line)))
        .orElseGet(() -> layout.insertFirst(scene, List.of(line)));
  }

  private boolean holdsArea(DocumentElement child) {
    return enrichment.sensors().stream()
        .anyMatch(
            sensor ->
                child.contains(sensor.element())
                    && LocalCoordinateSystem.of(sensor.element()).isPresent());
  }

  /**
   * Moves or resizes an area: changes only {@code center} and {@code size} of its sensor.
   *
   * @param name name of the undo step, such as {@code Move Desk}
   */
  public Edit place(AreaInstance area, AreaBox box, String name) {
    sound(box);
    DocumentElement sensor = area.element();
    Vector3d centre = vector(area.frame().ownCentre(box));
    Vector3d size = vector(area.frame().ownSize(box));
    List<TextEdit> changes = new ArrayList<>();
    float[] oldCentre = AreaLocator.centre(sensor);
    float[] oldSize = AreaLocator.size(sensor);
    if (differs(centre, oldCentre, size)) {
      changes.add(document.layout().attribute(sensor, "center", text(centre, oldCentre, size)));
    }
    if (differs(size, oldSize, size)) {
      changes.add(document.layout().attribute(sensor, "size", text(size, oldSize, size)));
    }
    return new Edit(name, changes);
  }

  /** Adds a translated copy of an area with its schemas, as another part of the same area. */
  public Edit copy(AreaInstance area, String name, Vector3dc shift) {
    List<TextEdit> moved = place(area, area.box().movedBy(shift), "").changes();
    return new Edit("Copy " + area.name(), List.of(nodes.copied(area.element(), name, moved)));
  }

  private static Vector3d vector(float[] of) {
    return new Vector3d(of[0], of[1], of[2]);
  }

  private static void sound(AreaBox box) {
    if (!box.sound()) {
      throw new EditRejectedException(
          "the width, height and depth of an area must be greater than 0");
    }
  }

  private static boolean differs(Vector3dc wanted, float[] old, Vector3dc size) {
    for (int i = 0; i < 3; i++) {
      if (!same(wanted.get(i), old[i], size)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns whether a number equals the written one within a tolerance relative to the area's size.
   */
  private static boolean same(double wanted, float old, Vector3dc size) {
    double unit = Math.min(size.x(), Math.min(size.y(), size.z()));
    return Math.abs(wanted - old) <= SAME * Math.max(unit, Math.abs((double) old));
  }

  /**
   * Formats numbers to a thousandth of the smallest side or better; unchanged numbers stay as they
   * were.
   */
  private static String text(Vector3dc wanted, float[] old, Vector3dc size) {
    double least = Math.min(size.x(), Math.min(size.y(), size.z()));
    int decimals = (int) Math.max(4, Math.min(9, 3 - Math.floor(Math.log10(least))));
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 3; i++) {
      text.append(i == 0 ? "" : " ")
          .append(
              same(wanted.get(i), old[i], size)
                  ? DecimalFormatter.shortest(old[i])
                  : DecimalFormatter.rounded(wanted.get(i), decimals));
    }
    return text.toString();
  }
}
