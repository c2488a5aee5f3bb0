package org.selectiverenderer.authoring.versions;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Hints by which elements without names are told apart: what a reader of the file takes them for,
 * as {@link VersionsEdit#proposedName} does, else their geometry. Hints are kept as long as the
 * text stays. Not thread-safe.
 */
public final class ElementHints {
  private static final Set<String> HINTED =
      Set.of(
          "Transform",
          "Group",
          "StaticGroup",
          "Shape",
          "Anchor",
          "Billboard",
          "Collision",
          "LOD",
          "Switch",
          "Inline",
          "ProtoInstance",
          "CADAssembly",
          "CADFace",
          "CADLayer",
          "CADPart");

  /** The fields of geometry by whose indices polygons are counted. */
  private static final Map<String, String> INDICES =
      Map.of("IndexedFaceSet", "coordIndex", "IndexedTriangleSet", "index");

  /** The longest field that is counted, in characters, so that a tree is drawn at once. */
  private static final int LONGEST = 8_000_000;

  private final SceneDocument document;
  private final Map<DocumentElement, Optional<Hint>> known = new WeakHashMap<>();
  private final Map<DocumentElement, Count> counts = new WeakHashMap<>();
  private long revision = -1;

  /**
   * A hint.
   *
   * @param content a word for what is in the element
   * @param polygons the triangles of its only geometry; 0 where they are not counted
   */
  public record Hint(String content, int polygons) {}

  private record Count(long changed, int polygons) {}

  /** Creates hints for the elements of a document. */
  public ElementHints(SceneDocument document) {
    this.document = document;
  }

  /** Returns the hint for an element; empty for one that has a name or nothing to tell. */
  public Optional<Hint> of(DocumentElement element) {
    boolean bare = element.def().isEmpty() && element.use().isEmpty();
    if (!bare || !element.attached() || !HINTED.contains(element.name())) {
      return Optional.empty();
    }
    if (revision != document.revision()) {
      revision = document.revision();
      known.clear();
    }
    return known.computeIfAbsent(element, this::found);
  }

  private Optional<Hint> found(DocumentElement element) {
    Optional<String> name = ObjectNamer.found(document.text(), element);
    if (name.isPresent()) {
      return name.map(word -> new Hint(word, 0));
    }
    return ObjectNamer.geometry(element)
        .map(geometry -> new Hint(geometry.name(), polygons(geometry)));
  }

  private int polygons(DocumentElement geometry) {
    Count count = counts.get(geometry);
    if (count == null || count.changed() != geometry.changed()) {
      count = new Count(geometry.changed(), count(geometry));
      counts.put(geometry, count);
    }
    return count.polygons();
  }

  private static int count(DocumentElement geometry) {
    String field = INDICES.get(geometry.name());
    String indices = field == null ? "" : geometry.text(field).orElse("");
    return indices.length() > LONGEST
        ? 0
        : triangles(indices, geometry.name().equals("IndexedFaceSet"));
  }

  private static int triangles(String indices, boolean faces) {
    int corners = 0;
    int ends = 0;
    boolean open = false;
    for (int i = 0; i < indices.length(); i++) {
      char c = indices.charAt(i);
      boolean begins = !separates(c) && (i == 0 || separates(indices.charAt(i - 1)));
      if (begins && c == '-') {
        ends += open ? 1 : 0;
        open = false;
      } else if (begins) {
        corners++;
        open = true;
      }
    }
    int all = ends + (open ? 1 : 0);
    return faces ? Math.max(0, corners - 2 * all) : corners / 3;
  }

  private static boolean separates(char c) {
    return c == ',' || Character.isWhitespace(c);
  }
}
