package org.selectiverenderer.enricher.preview;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.enricher.preview.ScenePatch.Place;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * A part of a document that holds all that has changed, small enough to be compared with what it
 * was while the author waits. A value.
 *
 * @param kind what of its owner it is
 * @param owner the element that it belongs to
 * @param at where the owner's start tag is
 * @param range the part
 * @param place of the part's beginning
 * @param sibling the nearest node before it in the owner, for a content; empty for none
 */
record ChangedPart(
    Kind kind, String owner, Place at, ChangedRange range, Place place, Optional<Sibling> sibling) {
  /** Says what of an element has changed. */
  enum Kind {
    /** Its start tag. */
    TAG,
    /** Some of its children. */
    CONTENT,
    /** Anything of it. */
    WHOLE
  }

  /**
   * A node before the part.
   *
   * @param known whether it is written there, not only used
   */
  record Sibling(Place place, boolean known) {}

  static final String SCENE = "Scene";

  /** Most characters of a part; loading all again is not much slower beyond. */
  private static final int MOST = 2_000_000;

  private static final Set<String> STATEMENTS =
      Set.of("ROUTE", "IMPORT", "EXPORT", "ProtoDeclare", "ExternProtoDeclare");

  /**
   * Returns the parts of a document that hold a change, the smallest first; none where it has to be
   * loaded again in any case. For the document's thread; reads no text but that of the part.
   */
  static List<ChangedPart> of(SceneDocument document, ChangedRange change, NodeCatalogue nodes) {
    Optional<ElementTree> tree = document.tree();
    if (tree.isEmpty() || !document.entities().none()) {
      return List.of();
    }
    DocumentElement element = around(tree.get(), change);
    if (element == null || !known(element, nodes)) {
      return List.of();
    }
    List<ChangedPart> parts = new ArrayList<>();
    DocumentElement owner = ownerOfMetadata(element);
    Finder finder = new Finder(document, change);
    if (owner == element) {
      finder.tag(element).ifPresent(parts::add);
      if (change.from() >= element.tagEnd()) {
        finder.content(element, change.from(), change.to()).ifPresent(parts::add);
      }
    }
    finder.whole(owner).ifPresent(parts::add);
    DocumentElement child = owner;
    while (child.parent().isPresent()) {
      DocumentElement parent = child.parent().get();
      if (groups(parent, nodes)) {
        finder.content(parent, child.start(), child.end()).ifPresent(parts::add);
        break;
      }
      child = parent;
    }
    return parts;
  }

  private static @Nullable DocumentElement around(ElementTree tree, ChangedRange change) {
    DocumentElement found = tree.at(Math.max(0, change.from() - 1)).orElse(null);
    while (found != null && (found.start() >= change.from() || found.end() <= change.to())) {
      found = found.parent().orElse(null);
    }
    return found;
  }

  /** Whether an element and all around it are nodes of the scene, and no code. */
  private static boolean known(DocumentElement element, NodeCatalogue nodes) {
    boolean inScene = false;
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      inScene |= at.name().equals(SCENE);
      boolean frame = at.name().equals(SCENE) || at.parent().isEmpty();
      Optional<NodeType> type = nodes.find(at.name());
      if (!frame && type.filter(each -> !SceneTextDiff.holdsCode(each)).isEmpty()) {
        return false;
      }
    }
    return inScene;
  }

  private static DocumentElement ownerOfMetadata(DocumentElement element) {
    DocumentElement owner = element;
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      if (SceneTextDiff.isMetadata(at) && at.parent().isPresent()) {
        owner = at.parent().get();
      }
    }
    return owner;
  }

  private static boolean groups(DocumentElement element, NodeCatalogue nodes) {
    Optional<NodeType> type = nodes.find(element.name());
    return element.name().equals(SCENE)
        || type.filter(each -> each.is("X3DGroupingNode")).isPresent();
  }

  /** The parts of a document that hold one change. */
  private record Finder(SceneDocument document, ChangedRange change) {
    Optional<ChangedPart> tag(DocumentElement of) {
      int name = of.start() + 1 + of.name().length();
      boolean within = change.from() > name && change.to() < of.tagEnd();
      return within && !of.name().equals(SCENE)
          ? part(Kind.TAG, of, of.start(), of.tagEnd(), Optional.empty())
          : Optional.empty();
    }

    Optional<ChangedPart> whole(DocumentElement of) {
      return of.name().equals(SCENE) || of.start() >= change.from()
          ? Optional.empty()
          : part(Kind.WHOLE, of, of.start(), of.end(), Optional.empty());
    }

    /** Returns the part of an element's content from the child before a range to that behind it. */
    Optional<ChangedPart> content(DocumentElement of, int from, int to) {
      int start = of.tagEnd();
      int end = of.end() - 1;
      while (end > start && document.text().charAt(end) != '<') {
        end--;
      }
      Optional<Sibling> before = Optional.empty();
      for (DocumentElement child : of.children()) {
        if (child.end() <= from) {
          start = child.end();
          if (!STATEMENTS.contains(child.name()) && !SceneTextDiff.isMetadata(child)) {
            before = Optional.of(new Sibling(place(child.start()), child.use().isEmpty()));
          }
        } else if (child.start() >= to) {
          end = child.start();
          break;
        }
      }
      return start <= change.from() && change.to() <= end
          ? part(Kind.CONTENT, of, start, end, before)
          : Optional.empty();
    }

    private Optional<ChangedPart> part(
        Kind kind, DocumentElement of, int from, int to, Optional<Sibling> sibling) {
      boolean prefixed = !document.text(of.start() + 1, of.tagEnd()).startsWith(of.name());
      if (prefixed || to - from > MOST || to - from - change.growth() > MOST) {
        return Optional.empty();
      }
      ChangedRange range = new ChangedRange(from, to, change.growth());
      return Optional.of(
          new ChangedPart(kind, of.name(), place(of.start()), range, place(from), sibling));
    }

    private Place place(int offset) {
      int line = document.location(offset).line();
      return new Place(line, offset - document.offset(line, 1) + 1);
    }
  }
}
