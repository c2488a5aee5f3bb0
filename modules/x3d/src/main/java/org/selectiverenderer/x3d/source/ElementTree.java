package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;

/** The tree of the elements of a well-formed text, which is updated incrementally by edits. */
public final class ElementTree {
  /** The number of changes from which on parsing the whole text is faster. */
  private static final int MANY = 2000;

  /** Characters behind a change in which a fault is looked for first. */
  private static final long FIRST_LOOK = 1 << 16;

  /** Characters before the end of such a part where a fault may come from its being cut there. */
  private static final int CUT = 64;

  private final DocumentElement root;
  private final ElementSource source;
  private final ElementIndex names = new ElementIndex();

  /** What has kept the last changes from being followed, if that is known. */
  private @Nullable BrokenPart broken;

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

  /**
   * A part of the changed text that is not well-formed, where all before it is.
   *
   * @param head start tags of the elements that are open at its beginning
   */
  private record BrokenPart(int from, String head) {}

  /** Marks all elements as removed, since the text is not well-formed or will be parsed again. */
  public void detach() {
    root.detach();
  }

  /** Marks all elements as present again, when the text is well-formed again. */
  public void attach() {
    root.attach();
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
   * @return false, without a change, if that was not possible: then the tree is that of the text
   *     before; {@link #fault} may say why
   */
  public boolean follow(List<TextEdit> changes, long revision) {
    broken = null;
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
    OffsetMapping moved = new OffsetMapping(changes);
    Map<DocumentElement, Part> parts = new IdentityHashMap<>();
    ranges.forEach((element, range) -> parts.put(element, part(element, range)));
    List<DocumentElement> inOrder = new ArrayList<>(parts.keySet());
    inOrder.sort(Comparator.comparingInt(element -> start(element, parts.get(element))));
    Map<DocumentElement, DocumentElement> parsed = new IdentityHashMap<>();
    for (DocumentElement element : inOrder) {
      DocumentElement read = readAgain(element, parts.get(element), moved, revision);
      if (read == null) {
        return false;
      }
      parsed.put(element, read);
    }
    root.move(moved);
    parts.forEach((element, part) -> replace(element, part, parsed.get(element), revision));
    return true;
  }

  /** Returns the offset at which a part begins, before the changes. */
  private static int start(DocumentElement element, Part part) {
    return part.before() == 0 ? element.start() : element.children().get(part.before() - 1).end();
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

  /** Parses a part of the changed text; null if it has to be parsed with all around it. */
  private @Nullable DocumentElement readAgain(
      DocumentElement element, Part part, OffsetMapping moved, long revision) {
    CharSequence text = source.characters();
    List<DocumentElement> children = element.children();
    int last = children.size() - part.behind();
    int from =
        part.before() == 0
            ? moved.start(element.start())
            : moved.end(children.get(part.before() - 1).end());
    int to =
        part.behind() == 0 ? moved.end(element.end()) : moved.start(children.get(last).start());
    String name = written(element, moved, text);
    String head = part.before() == 0 ? "" : "<" + name + ">";
    String tail = part.behind() == 0 ? "" : "</" + name + ">";
    SourceText piece = SourceText.of(head + text.subSequence(from, to) + tail);
    DocumentElement parsed;
    try {
      parsed = ElementParser.root(piece, source, from - head.length(), revision);
    } catch (XmlParseException e) {
      broken = new BrokenPart(from, around(element, moved, text) + head);
      return null; // the text from there on is parsed next, which reports the error
    }
    boolean other =
        part.before() == 0 && part.behind() > 0 && !parsed.name().equals(element.name());
    return other ? null : parsed;
  }

  /** Returns the start tags of the elements around another, without their attributes. */
  private static String around(DocumentElement element, OffsetMapping moved, CharSequence text) {
    StringBuilder tags = new StringBuilder();
    for (DocumentElement at = element.parent().orElse(null);
        at != null;
        at = at.parent().orElse(null)) {
      tags.insert(0, "<" + written(at, moved, text) + ">");
    }
    return tags.toString();
  }

  private void replace(DocumentElement element, Part part, DocumentElement parsed, long revision) {
    List<DocumentElement> children = element.children();
    int last = children.size() - part.behind();
    for (DocumentElement gone : new ArrayList<>(children.subList(part.before(), last))) {
      names.remove(gone);
      gone.detach();
    }
    names.removeOne(element);
    element.graft(part.before(), part.behind(), parsed, part.before() == 0, revision);
    names.addOne(element);
    parsed.children().forEach(names::add);
  }

  /**
   * Returns the fault of the text whose changes could not be followed, found by parsing no more of
   * it than from the changed part to the fault; empty if all of it has to be parsed.
   */
  public Optional<DocumentError> fault() {
    BrokenPart part = broken;
    if (part == null || !source.entities().none()) {
      return Optional.empty();
    }
    CharSequence text = source.characters();
    int near = Math.max(0, part.from - XmlErrorMessages.LONGEST_REFERENCE);
    if (text.subSequence(near, part.from).toString().indexOf('&') >= 0) {
      return Optional.empty(); // A fault may be located at a reference before it.
    }
    for (long size = FIRST_LOOK; ; size *= 8) {
      int end = (int) Math.min(text.length(), part.from + size);
      String piece = part.head + text.subSequence(part.from, end);
      DocumentError found = fault(piece);
      boolean whole = end == text.length();
      if (found == null ? whole : !found.plain()) {
        return Optional.empty();
      }
      if (found != null && (whole || offset(found, piece) < piece.length() - CUT)) {
        return Optional.of(inText(found, part, text));
      }
    }
  }

  private @Nullable DocumentError fault(String piece) {
    try {
      ElementParser.root(SourceText.of(piece), source, 0, 0);
      return null;
    } catch (XmlParseException e) {
      return e.fault();
    }
  }

  private static int offset(DocumentError fault, String piece) {
    return new LineIndex(piece).start(piece, fault.location().line()) + fault.location().column();
  }

  /** Returns a fault that was found in a part with its location in the text. */
  private DocumentError inText(DocumentError found, BrokenPart part, CharSequence text) {
    SourceLocation at = found.location();
    int start = part.from;
    while (start > 0 && text.charAt(start - 1) != '\n' && text.charAt(start - 1) != '\r') {
      start--;
    }
    int line = source.location(part.from).line() + at.line() - 1;
    int column = at.line() > 1 ? at.column() : at.column() - part.head.length() + part.from - start;
    return new DocumentError(
        found.kind(), new SourceLocation(at.file(), line, column), found.message());
  }

  /** Returns the name in a start tag with its prefix. */
  private static String written(DocumentElement element, OffsetMapping moved, CharSequence text) {
    int start = moved.start(element.start()) + 1;
    int most = moved.end(element.tagEnd());
    int end = start;
    while (end < most && text.charAt(end) > ' ' && "/>".indexOf(text.charAt(end)) < 0) {
      end++;
    }
    return text.subSequence(start, end).toString();
  }
}
