package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** The tree of the elements of a well-formed text, which is updated incrementally by edits. */
public final class ElementTree {
  /** The number of changes from which on parsing the whole text is faster. */
  private static final int MANY = 2000;

  private final DocumentElement root;
  private final ElementSource source;
  private final ElementIndex names = new ElementIndex();

  ElementTree(DocumentElement root, ElementSource source) {
    this.root = root;
    this.source = source;
    names.add(root);
  }

  /**
   * Parses a text.
   *
   * @param revision the revision of the text
   * @throws XmlParseException at the first place where the text is not well-formed, is nested too
   *     deeply, or has a tag with too many attributes
   */
  public static ElementTree of(ElementSource source, long revision) throws XmlParseException {
    SourceText text = SourceText.of(source.characters());
    return new ElementTree(ElementParser.root(text, source, 0, revision), source);
  }

  /** The numbers of children before and after the part of an element that is parsed again. */
  private record Part(int before, int behind) {}

  /** Marks all elements as removed, since the whole text will be parsed again. */
  public void detach() {
    root.detach();
  }

  /** Returns the root element, which is X3D in a scene. */
  public DocumentElement root() {
    return root;
  }

  /** Returns the first element Scene in the root; empty if the text is not a scene. */
  public Optional<DocumentElement> scene() {
    return root.children().stream().filter(child -> child.name().equals("Scene")).findFirst();
  }

  /**
   * Returns the element with a DEF name in the scene, outside of the declarations of prototypes;
   * the first one if the name is wrongly repeated.
   */
  public Optional<DocumentElement> named(String def) {
    return names.find(def, root);
  }

  /** Returns the element that a DEF name means at an element, in the {@link ElementScope}. */
  public Optional<DocumentElement> named(String def, DocumentElement at) {
    return names.find(def, ElementScope.of(at));
  }

  /** Returns whether any element in the scene, outside of prototypes, has a name as USE. */
  public boolean used(String def) {
    return names.used(def, root);
  }

  /** Returns whether any element of the {@link ElementScope} of an element has a name as USE. */
  public boolean used(String def, DocumentElement at) {
    return names.used(def, ElementScope.of(at));
  }

  /** Returns whether a name occurs as DEF or USE in any scope. */
  public boolean occurs(String name) {
    return names.anywhere(name);
  }

  /**
   * Returns all Switches without USE, in document order; the same list object as long as they are
   * unchanged.
   */
  public List<DocumentElement> switches() {
    return names.ofType("Switch");
  }

  /** Returns all ProximitySensors without USE, as {@link #switches} does. */
  public List<DocumentElement> sensors() {
    return names.ofType("ProximitySensor");
  }

  /** Returns all ProtoInstances without USE, as {@link #switches} does. */
  public List<DocumentElement> instances() {
    return names.ofType("ProtoInstance");
  }

  /** Returns all ROUTEs, as {@link #switches} does. */
  public List<DocumentElement> routes() {
    return names.ofType("ROUTE");
  }

  /**
   * Returns the ProtoDeclare or ExternProtoDeclare that a prototype's name means at an element: the
   * last one before it in its scope, else in the scopes around (X3D 4.0, 4.4.4.3).
   */
  public Optional<DocumentElement> prototype(String name, DocumentElement at) {
    DocumentElement scope = ElementScope.of(at);
    while (true) {
      Optional<DocumentElement> found = prototype(name, scope, at);
      if (found.isPresent() || scope.parent().isEmpty()) {
        return found;
      }
      scope = ElementScope.of(scope);
    }
  }

  private Optional<DocumentElement> prototype(
      String name, DocumentElement scope, DocumentElement at) {
    return Stream.of("ProtoDeclare", "ExternProtoDeclare")
        .flatMap(kind -> last(names.ofType(kind), name, scope, at).stream())
        .max(Comparator.comparingInt(DocumentElement::start));
  }

  private static Optional<DocumentElement> last(
      List<DocumentElement> declarations, String name, DocumentElement scope, DocumentElement at) {
    for (int i = declarations.size() - 1; i >= 0; i--) {
      DocumentElement declaration = declarations.get(i);
      if (declaration.start() < at.start()
          && !declaration.contains(at)
          && ElementScope.of(declaration) == scope
          && declaration.text("name").map(String::strip).filter(name::equals).isPresent()) {
        return Optional.of(declaration);
      }
    }
    return Optional.empty();
  }

  /** Returns the innermost element at an offset; empty outside the root. */
  public Optional<DocumentElement> at(int offset) {
    return offset < root.start() || offset >= root.end()
        ? Optional.empty()
        : Optional.of(smallest(root, offset, offset + 1));
  }

  /** Returns the innermost element within another that contains a range. */
  private static DocumentElement smallest(DocumentElement in, int from, int to) {
    DocumentElement found = in;
    while (true) {
      List<DocumentElement> children = found.children();
      int behind = firstFrom(children, from + 1);
      DocumentElement child = behind == 0 ? null : children.get(behind - 1);
      if (child == null || child.end() < to) {
        return found;
      }
      found = child;
    }
  }

  /** Returns the index of the first element that starts at or after an offset. */
  private static int firstFrom(List<DocumentElement> elements, int offset) {
    int low = 0;
    int high = elements.size();
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (elements.get(middle).start() < offset) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /**
   * Updates the tree after changes of the text, parsing again only the affected elements.
   *
   * @param revision the revision of the text after the changes, which the source already has
   * @return false if that was not possible; the tree is then invalid and must be parsed anew
   */
  public boolean follow(List<TextEdit> changes, long revision) {
    if (changes.size() > MANY) {
      return false;
    }
    Map<DocumentElement, int[]> ranges = new IdentityHashMap<>();
    for (TextEdit change : changes) {
      if (change.from() <= root.start() || change.to() >= root.end()) {
        return false;
      }
      DocumentElement element = smallest(root, change.from() - 1, change.to() + 1);
      ranges.merge(
          element,
          new int[] {change.from(), change.to()},
          (a, b) -> new int[] {Math.min(a[0], b[0]), Math.max(a[1], b[1])});
    }
    ranges.keySet().removeIf(element -> readWithAnother(element, ranges));
    Map<DocumentElement, Part> parts = new IdentityHashMap<>();
    ranges.forEach((element, range) -> parts.put(element, part(element, range)));
    root.move(new OffsetMapping(changes));
    for (Map.Entry<DocumentElement, Part> part : parts.entrySet()) {
      if (!readAgain(part.getKey(), part.getValue(), revision)) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether an element lies in the part of an ancestor that is parsed again. */
  private static boolean readWithAnother(
      DocumentElement element, Map<DocumentElement, int[]> ranges) {
    DocumentElement child = element;
    while (child.parent().isPresent()) {
      DocumentElement parent = child.parent().get();
      int[] range = ranges.get(parent);
      if (range != null && child.end() > range[0] && child.start() < range[1]) {
        return true;
      }
      child = parent;
    }
    return false;
  }

  private static Part part(DocumentElement element, int[] range) {
    List<DocumentElement> children = element.children();
    int before = firstFrom(children, range[0]);
    if (before > 0 && children.get(before - 1).end() > range[0]) {
      before--;
    }
    return new Part(before, children.size() - Math.max(before, firstFrom(children, range[1])));
  }

  private boolean readAgain(DocumentElement element, Part part, long revision) {
    CharSequence text = source.characters();
    List<DocumentElement> children = element.children();
    int last = children.size() - part.behind();
    int from = part.before() == 0 ? element.start() : children.get(part.before() - 1).end();
    int to = part.behind() == 0 ? element.end() : children.get(last).start();
    String name = written(element, text);
    String head = part.before() == 0 ? "" : "<" + name + ">";
    String tail = part.behind() == 0 ? "" : "</" + name + ">";
    SourceText piece = SourceText.of(head + text.subSequence(from, to) + tail);
    DocumentElement parsed;
    try {
      parsed = ElementParser.root(piece, source, from - head.length(), revision);
    } catch (XmlParseException e) {
      return false; // the whole text is parsed next, which reports the error
    }
    if (part.before() == 0 && part.behind() > 0 && !parsed.name().equals(element.name())) {
      return false;
    }
    for (DocumentElement gone : new ArrayList<>(children.subList(part.before(), last))) {
      names.remove(gone);
      gone.detach();
    }
    names.removeOne(element);
    element.graft(part.before(), part.behind(), parsed, part.before() == 0, revision);
    names.addOne(element);
    parsed.children().forEach(names::add);
    return true;
  }

  /** Returns the name in a start tag with its prefix. */
  private static String written(DocumentElement element, CharSequence text) {
    int end = element.start() + 1;
    while (end < element.tagEnd() && text.charAt(end) > ' ' && "/>".indexOf(text.charAt(end)) < 0) {
      end++;
    }
    return text.subSequence(element.start() + 1, end).toString();
  }
}
