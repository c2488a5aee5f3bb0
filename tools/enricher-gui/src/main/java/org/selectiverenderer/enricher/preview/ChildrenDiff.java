package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.enricher.preview.ScenePatch.Place;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Tells which children of a group are others, if a running scene can take them over without loading
 * the rest: plain nodes that nothing outside refers to, and that refer to nothing.
 */
final class ChildrenDiff {
  /** The farthest column of new nodes that are read apart, as blanks keep their places. */
  private static final int FARTHEST = 8_000_000;

  /** Most names that are looked for in the rest of the text. */
  private static final int NAMES = 16;

  /** The types of nodes that can come and go. Those that are bound or run by themselves cannot. */
  private static final List<String> PLAIN =
      List.of(
          "X3DShapeNode",
          "X3DGroupingNode",
          "X3DGeometryNode",
          "X3DGeometricPropertyNode",
          "X3DAppearanceNode",
          "X3DAppearanceChildNode",
          "X3DMetadataObject",
          "X3DLightNode",
          "X3DEnvironmentalSensorNode");

  private static final List<String> NOT_PLAIN =
      List.of("X3DTimeDependentNode", "X3DBindableNode", "X3DNetworkSensorNode", "X3DUrlObject");

  /** Types with a url that only brings a picture. */
  private static final Set<String> PICTURES = Set.of("ImageTexture");

  private final NodeCatalogue catalogue;
  private final String before;
  private final String after;
  private final PartPlaces places;

  /**
   * @param before the whole text
   * @param after the whole text
   * @param places of the elements
   */
  ChildrenDiff(NodeCatalogue catalogue, String before, String after, PartPlaces places) {
    this.catalogue = catalogue;
    this.before = before;
    this.after = after;
    this.places = places;
  }

  /**
   * Returns the other children.
   *
   * @param kept the children of the part that are the same, before them
   * @param text of the part, after
   */
  Optional<ScenePatch.Children> of(
      ChangedPart part,
      List<DocumentElement> kept,
      List<DocumentElement> gone,
      List<DocumentElement> come,
      String text) {
    List<String> unnamed = new ArrayList<>();
    List<String> named = new ArrayList<>();
    if (!groups(part.owner())
        || before.contains("<unit")
        || !plain(gone, unnamed)
        || !plain(come, named)
        || Set.copyOf(named).size() < named.size()
        || unnamed.stream().anyMatch(name -> outside(part.range(), name, named.contains(name)))
        || named.stream().anyMatch(name -> !unnamed.contains(name) && quotedIn(name, before))) {
      return Optional.empty();
    }
    Optional<ChangedPart.Sibling> sibling = sibling(kept).or(part::sibling);
    if (sibling.filter(node -> !node.known()).isPresent()) {
      return Optional.empty();
    }
    String added = "";
    if (!come.isEmpty()) {
      Place place = places.of(come.get(0).location());
      if (place.line() < 2 || place.column() > FARTHEST) {
        return Optional.empty();
      }
      added =
          "\n".repeat(place.line() - 1)
              + " ".repeat(place.column() - 1)
              + text.substring(come.get(0).start(), come.get(come.size() - 1).end());
    }
    return Optional.of(
        new ScenePatch.Children(
            part.owner().equals(ChangedPart.SCENE) ? Optional.empty() : Optional.of(part.at()),
            part.owner(),
            gone.stream().map(each -> places.of(each.location())).toList(),
            unnamed,
            sibling.map(ChangedPart.Sibling::place),
            added,
            come.size()));
  }

  private boolean groups(String owner) {
    return owner.equals(ChangedPart.SCENE)
        || catalogue.find(owner).filter(type -> type.is("X3DGroupingNode")).isPresent();
  }

  /** Whether elements are plain nodes; gathers their names. */
  private boolean plain(List<DocumentElement> elements, List<String> names) {
    boolean[] plain = {true};
    for (DocumentElement element : elements) {
      element.visit(
          each -> {
            plain[0] &= plain(each);
            each.def().ifPresent(names::add);
          });
    }
    return plain[0] && names.size() <= NAMES;
  }

  private boolean plain(DocumentElement element) {
    Optional<NodeType> type = catalogue.find(element.name());
    return type.isPresent()
        && element.use().isEmpty()
        && PLAIN.stream().anyMatch(type.get()::is)
        && (PICTURES.contains(element.name()) || NOT_PLAIN.stream().noneMatch(type.get()::is))
        && !SceneTextDiff.holdsCode(type.get());
  }

  /** Whether what stays refers to a name that is gone, or has been given again within the part. */
  private boolean outside(ChangedRange part, String name, boolean again) {
    return again
        ? quotedIn(name, after.substring(0, part.from()))
            || quotedIn(name, after.substring(part.to()))
        : quotedIn(name, after);
  }

  private static boolean quotedIn(String name, String text) {
    return SceneTextDiff.quoted(name, text);
  }

  private Optional<ChangedPart.Sibling> sibling(List<DocumentElement> kept) {
    for (int i = kept.size() - 1; i >= 0; i--) {
      DocumentElement each = kept.get(i);
      if (catalogue.find(each.name()).isPresent() || each.name().equals("ProtoInstance")) {
        return Optional.of(
            new ChangedPart.Sibling(places.of(each.location()), each.use().isEmpty()));
      }
    }
    return Optional.empty();
  }
}
