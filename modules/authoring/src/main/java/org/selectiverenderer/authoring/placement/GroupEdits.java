package org.selectiverenderer.authoring.placement;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.joml.Matrix4d;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.area.LocalCoordinateSystem;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.authoring.nodes.Reindenter;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Creates edits that put several nodes into a new Transform, and that replace a group by what is in
 * it. All throw {@link EditRejectedException} with a sentence for the author where the scene would
 * not stay as it is.
 */
public final class GroupEdits {
  private static final Set<String> DECLARATIONS = Set.of("ProtoDeclare", "ExternProtoDeclare");

  private static final Set<String> CHOOSING = Set.of("Switch", "LOD");

  private static final Set<String> GROUPS = Set.of("Transform", "Group", "StaticGroup");

  /** Fields that a group may have and still be replaced by its children. */
  private static final Set<String> DISSOLVED =
      Set.of(
          "DEF",
          "translation",
          "rotation",
          "scale",
          "center",
          "scaleOrientation",
          "bboxCenter",
          "bboxSize",
          "containerField");

  /** Ungrouped nodes stay where they are, so that their numbers get a decimal more. */
  private static final double FINER = 10;

  private final SceneDocument document;
  private final NodeCatalogue catalogue;
  private final ChildSemantics children;

  /**
   * @param catalogue the node types
   */
  public GroupEdits(SceneDocument document, NodeCatalogue catalogue) {
    this.document = document;
    this.catalogue = catalogue;
    children = new ChildSemantics(document, catalogue);
  }

  /**
   * Puts siblings into a new Transform, in their order.
   *
   * @param nodes children of one group, in any order
   * @param name the DEF name of the new Transform, unused in the scope of the nodes
   */
  public Edit group(List<DocumentElement> nodes, String name) {
    List<DocumentElement> siblings =
        nodes.stream().sorted(Comparator.comparingInt(DocumentElement::start)).toList();
    new NodeEdits(document).check(name, siblings.get(0));
    for (DocumentElement node : siblings) {
      if (!Placement.movable(catalogue, node)) {
        throw new EditRejectedException(
            node + " does not stand in the scene by itself, so it cannot be grouped");
      }
      if (!node.parent().equals(siblings.get(0).parent())) {
        throw new EditRejectedException(
            node
                + " is in another group than "
                + siblings.get(0)
                + "; select nodes of one group only");
      }
    }
    refuseChoices(siblings.get(0));
    DocumentElement at = place(siblings);
    SourceFormatter layout = document.layout();
    String open =
        "<Transform" + SourceFormatter.written("DEF", name, layout.quote(siblings.get(0))) + ">";
    boolean laid = layout.onItsOwnLine(at);
    String outer = laid ? layout.endOfLine(at) + layout.indentation(at) : "";
    String step = laid ? layout.step(at) : "";
    StringBuilder text = new StringBuilder(open);
    for (DocumentElement node : siblings) {
      text.append(outer).append(step).append(Reindenter.deeper(document.text(node), step));
    }
    text.append(outer).append("</Transform>");
    List<TextEdit> changes = new ArrayList<>();
    changes.add(new TextEdit(at.start(), at.end(), text.toString()));
    siblings.stream().filter(node -> node != at).forEach(node -> changes.add(layout.remove(node)));
    return new Edit("Group " + siblings.size() + " nodes", changes);
  }

  /** Refuses to change how many children a Switch or LOD has, which are known by their number. */
  private static void refuseChoices(DocumentElement child) {
    Optional<DocumentElement> parent = child.parent();
    if (parent.isPresent() && CHOOSING.contains(parent.get().name())) {
      throw new EditRejectedException(
          child
              + " is a choice of "
              + parent.get()
              + ", which are known by their number; group or ungroup what is inside of the choice");
    }
  }

  /** Returns the sibling whose place the group takes, so that each DEF stays before its USEs. */
  private DocumentElement place(List<DocumentElement> siblings) {
    DocumentElement first = siblings.get(0);
    DocumentElement last = siblings.get(siblings.size() - 1);
    List<DocumentElement> between =
        first.parent().orElseThrow().children().stream()
            .filter(each -> each.start() > first.start() && each.start() < last.start())
            .filter(each -> !siblings.contains(each))
            .toList();
    if (!meet(between, siblings)) {
      return first;
    }
    if (!meet(siblings, between)) {
      return last;
    }
    throw new EditRejectedException(
        "between the selected nodes stand others that share nodes (DEF and USE) or a prototype with them;"
            + " move them together first");
  }

  /**
   * Returns whether the first nodes define what the others refer to: a DEF that they USE, or a
   * prototype of which they have an instance.
   */
  private static boolean meet(List<DocumentElement> defining, List<DocumentElement> using) {
    Set<String> names = new HashSet<>();
    Set<String> prototypes = new HashSet<>();
    defining.forEach(
        node ->
            node.visit(
                each -> {
                  each.def().ifPresent(names::add);
                  if (DECLARATIONS.contains(each.name())) {
                    each.text("name").ifPresent(prototypes::add);
                  }
                }));
    List<DocumentElement> inside = new ArrayList<>();
    using.forEach(node -> node.visit(inside::add));
    return inside.stream()
        .anyMatch(
            each ->
                each.use().filter(names::contains).isPresent()
                    || each.name().equals("ProtoInstance")
                        && each.text("name").filter(prototypes::contains).isPresent());
  }

  /** Returns whether an element is a group that may be replaced by what is in it. */
  public static boolean isGroup(DocumentElement element) {
    return GROUPS.contains(element.name()) && element.use().isEmpty();
  }

  /** Replaces a group by its children, which stay where they are. */
  public Edit ungroup(DocumentElement group) {
    refuseChoices(group);
    check(group);
    List<DocumentElement> content = group.children();
    if (content.isEmpty()) {
      throw new EditRejectedException(group + " is empty; delete it instead");
    }
    TransformPose pose =
        group.name().equals("Transform") ? TransformPose.of(group) : TransformPose.IDENTITY;
    List<TextEdit> inside = new ArrayList<>();
    Matrix4d around =
        LocalCoordinateSystem.of(group).map(at -> new Matrix4d(at.world())).orElse(new Matrix4d());
    for (DocumentElement child : content) {
      if (!pose.equals(TransformPose.IDENTITY)) {
        inside.addAll(moved(child, pose, around.scale(FINER, new Matrix4d())));
      }
    }
    inside.sort(Comparator.comparingInt(TextEdit::from));
    int from = content.get(0).start();
    int to = content.get(content.size() - 1).end();
    String head = document.text(group.tagEnd(), from);
    String foot = document.text(to, group.end());
    foot = foot.substring(0, foot.lastIndexOf('<'));
    from = head.isBlank() ? from : from - head.stripLeading().length();
    to = foot.isBlank() ? to : to + foot.stripTrailing().length();
    int start = from;
    List<TextEdit> relative =
        inside.stream()
            .map(each -> new TextEdit(each.from() - start, each.to() - start, each.text()))
            .toList();
    String text = TextEdit.applied(relative, document.text(from, to)).toString();
    SourceFormatter layout = document.layout();
    DocumentElement first = content.get(0);
    String inner = layout.indentation(first);
    String outer = layout.indentation(group);
    String step =
        layout.onItsOwnLine(first) && inner.startsWith(outer)
            ? inner.substring(outer.length())
            : "";
    return new Edit(
        "Ungroup " + name(group),
        List.of(
            new TextEdit(
                group.start(),
                group.end(),
                step.isEmpty() ? text : Reindenter.shallower(text, step))));
  }

  private void check(DocumentElement group) {
    if (!isGroup(group)) {
      throw new EditRejectedException(
          group + " is no Transform or Group; select one to take it apart");
    }
    if (!Placement.movable(catalogue, group)) {
      throw new EditRejectedException(
          group + " does not stand among the children of a group, so it stays");
    }
    Optional<DocumentElement> reference = new NodeEdits(document).reference(group);
    if (reference.isPresent()) {
      throw new EditRejectedException(
          "%s is used in line %d (%s), and that would break; it stays"
              .formatted(
                  name(group),
                  document.location(reference.get().start()).line(),
                  reference.get().use().isPresent() ? "USE" : reference.get().name()));
    }
    for (SourceAttribute written : group.tag().attributes()) {
      if (!DISSOLVED.contains(written.name())) {
        throw new EditRejectedException(
            "%s has the field %s, which would be lost; it stays"
                .formatted(name(group), written.name()));
      }
    }
    for (DocumentElement child : group.children()) {
      if (children.scoped(child)) {
        throw new EditRejectedException(
            "%s holds a %s, which belongs to this group alone; move it out first"
                .formatted(name(group), child.name()));
      }
    }
  }

  private List<TextEdit> moved(DocumentElement child, TransformPose pose, Matrix4d around) {
    SourceFormatter layout = document.layout();
    if (!children.placed(child)) {
      return List.of();
    }
    boolean free =
        child.name().equals("Transform")
            && child.use().isEmpty()
            && new NodeEdits(document).reference(child).isEmpty();
    if (free) {
      TransformPose own = TransformPose.of(child);
      Matrix4d both = pose.matrix().mul(own.matrix());
      return new PlacementEdits(document)
          .changed(child, TransformPose.of(both, own.center()), around);
    }
    String fields = PlacementEdits.fields(pose, around, layout.quote(child));
    return fields.isEmpty()
        ? List.of()
        : List.of(
            new TextEdit(
                child.start(),
                child.end(),
                Reindenter.wrapped(document, child, "<Transform" + fields + ">", "</Transform>")));
  }

  private static String name(DocumentElement group) {
    return group.def().orElse(group.name());
  }
}
