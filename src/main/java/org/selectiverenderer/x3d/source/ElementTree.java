package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The elements of a well formed text. */
public final class ElementTree {
  /** Reading as many elements one by one takes as long as reading all of a large text. */
  private static final int MANY = 2000;

  private final DocumentElement root;
  private final ElementSource source;
  private final DefNames names = new DefNames();

  ElementTree(DocumentElement root, ElementSource source) {
    this.root = root;
    this.source = source;
    names.add(root);
  }

  /**
   * Reads a text.
   *
   * @param revision of the text, which its elements are of
   * @throws XmlFault at the first place where the text is not well formed, is nested deeper than a
   *     scene may be, or has a tag of more attributes than any node
   */
  public static ElementTree of(ElementSource source, long revision) throws XmlFault {
    SourceText text = SourceText.of(source.characters());
    return new ElementTree(ElementParser.root(text, source, 0, revision), source);
  }

  /** What stands of an element before and behind what is read again. */
  private record Part(int before, int behind) {}

  /** The text is to be read anew: the elements stand for nothing any more. */
  public void detach() {
    root.detach();
  }

  /** The element X3D, in a scene. */
  public DocumentElement root() {
    return root;
  }

  /** The first element Scene in the root; empty where the text has none, and so is no scene. */
  public Optional<DocumentElement> scene() {
    return root.children().stream().filter(child -> child.name().equals("Scene")).findFirst();
  }

  /** The element that gives a name by DEF; the first of several that wrongly give the same. */
  public Optional<DocumentElement> named(String def) {
    return names.find(def);
  }

  /** Whether a name is used by USE somewhere. */
  public boolean used(String def) {
    return names.used(def);
  }

  /**
   * All Switches, in document order; not those that stand for another by USE. The same list as
   * before as long as they are the same.
   */
  public List<DocumentElement> switches() {
    return names.ofType("Switch");
  }

  /** All ProximitySensors, likewise. */
  public List<DocumentElement> sensors() {
    return names.ofType("ProximitySensor");
  }

  /** The smallest element at an offset; empty outside of the root. */
  public Optional<DocumentElement> at(int offset) {
    return offset < root.start() || offset >= root.end()
        ? Optional.empty()
        : Optional.of(smallest(root, offset, offset + 1));
  }

  /** The smallest element within the given one that holds all of a range. */
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

  /** The index of the first element that starts at an offset or behind it. */
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
   * Follows changes of the text, reading again only the elements that they touch.
   *
   * @param revision of the text after the changes, which the source has now
   * @return false if that was not possible: the tree is of no use then and all is to be read again
   */
  public boolean follow(List<TextChange> changes, long revision) {
    if (changes.size() > MANY) {
      return false;
    }
    Map<DocumentElement, int[]> ranges = new IdentityHashMap<>();
    for (TextChange change : changes) {
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
    root.move(new OffsetShift(changes));
    for (Map.Entry<DocumentElement, Part> part : parts.entrySet()) {
      if (!readAgain(part.getKey(), part.getValue(), revision)) {
        return false;
      }
    }
    return true;
  }

  /** Whether an element lies in what is read again of one that it stands in. */
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
    } catch (XmlFault e) {
      return false; // all of the text is read next, and tells where the fault is
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

  /** The name in a start tag with its prefix. */
  private static String written(DocumentElement element, CharSequence text) {
    int end = element.start() + 1;
    while (end < element.tagEnd() && text.charAt(end) > ' ' && "/>".indexOf(text.charAt(end)) < 0) {
      end++;
    }
    return text.subSequence(element.start() + 1, end).toString();
  }
}
