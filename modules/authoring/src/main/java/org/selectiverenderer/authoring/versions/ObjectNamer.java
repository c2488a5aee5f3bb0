package org.selectiverenderer.authoring.versions;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * Proposes DEF names for objects without one, by what a reader of the file takes them for: the
 * comment above, a name inside, a prototype, the file of an Inline or of a texture, else the type
 * of geometry. Not thread-safe.
 */
final class ObjectNamer {
  /** The longest comment that is taken for a name; longer ones explain or are disabled code. */
  private static final int LONGEST = 48;

  private static final int WORDS = 3;

  /** The most elements of an object in which a name is looked for. */
  private static final int LOOKED_AT = 5000;

  private static final Pattern FILE = Pattern.compile("([^/\\\\#?]+?)(?:_v\\d+)?\\.[A-Za-z0-9]+$");
  private static final Pattern BETWEEN_WORDS = Pattern.compile("[^\\p{L}\\p{N}_-]+");

  /** Prefixes by which exporters mark kinds of nodes, and which say nothing of the object. */
  private static final Pattern PREFIX =
      Pattern.compile(
          "(?i)(?:transform|group|shape|mesh|geometry|coords?|material|mat|appearance"
              + "|app|texture|tex|image|ifs|faces)[_-](?=.)");

  private static final Pattern SUFFIX =
      Pattern.compile("(?i)[_-](?:transform|group|shape|mesh|geometry|material|mat|ifs|texture)$");

  private static final Set<String> TEXTURES = Set.of("ImageTexture", "MovieTexture");

  private final CharSequence text;
  private final UniqueNameGenerator names;

  ObjectNamer(CharSequence text, ElementTree tree) {
    this.text = text;
    this.names = new UniqueNameGenerator(tree);
  }

  /** Returns a name that no node has and that has not been returned before. */
  String name(DocumentElement element) {
    String wanted =
        found(text, element)
            .or(() -> geometry(element).map(DocumentElement::name).map(ObjectNamer::identifier))
            .orElse("Object");
    return names.free(inner(element, wanted) ? element.name() + "_" + wanted : wanted);
  }

  /** Whether a name is that of a node in an element: a number would tell of a second object. */
  private static boolean inner(DocumentElement element, String name) {
    return within(element).anyMatch(each -> each.def().filter(name::equals).isPresent());
  }

  /** Returns what a reader takes an element for; empty where only its geometry tells. */
  static Optional<String> found(CharSequence text, DocumentElement element) {
    List<Optional<String>> found = new ArrayList<>();
    found.add(comment(text, element));
    found.add(element.text("name"));
    found.add(first(element, inner -> url(inner, Set.of("Inline"))));
    found.add(first(element, inner -> plain(inner.def().or(inner::use))));
    found.add(first(element, ObjectNamer::prototype));
    found.add(first(element, inner -> url(inner, TEXTURES)));
    return found.stream()
        .flatMap(Optional::stream)
        .map(ObjectNamer::identifier)
        .filter(name -> !name.isEmpty())
        .findFirst();
  }

  /** Returns the comment directly above an element, unless it is long or holds markup. */
  private static Optional<String> comment(CharSequence text, DocumentElement element) {
    int at = element.start();
    while (at > 0 && Character.isWhitespace(text.charAt(at - 1))) {
      at--;
    }
    int close = at - "-->".length();
    if (close < 0 || !text.subSequence(close, at).toString().equals("-->")) {
      return Optional.empty();
    }
    String before = text.subSequence(Math.max(0, close - LONGEST - 8), close).toString();
    int open = before.lastIndexOf("<!--");
    String comment = open < 0 ? "" : before.substring(open + "<!--".length()).strip();
    return comment.length() > LONGEST || comment.matches("(?s).*[<>=].*")
        ? Optional.empty()
        : Optional.of(comment).filter(words -> !words.isEmpty());
  }

  private interface Reading {
    Optional<String> of(DocumentElement element);
  }

  private static Optional<String> first(DocumentElement element, Reading reading) {
    return within(element).flatMap(inner -> reading.of(inner).stream()).findFirst();
  }

  /** Returns an element and its descendants in document order, as far as they are looked at. */
  private static Stream<DocumentElement> within(DocumentElement element) {
    Deque<DocumentElement> open = new ArrayDeque<>(List.of(element));
    return Stream.generate(
            () -> {
              DocumentElement next = open.poll();
              if (next != null) {
                List<DocumentElement> children = next.children();
                for (int i = children.size() - 1; i >= 0; i--) {
                  open.push(children.get(i));
                }
              }
              return Optional.ofNullable(next);
            })
        .limit(LOOKED_AT)
        .takeWhile(Optional::isPresent)
        .flatMap(Optional::stream);
  }

  private static Optional<String> prototype(DocumentElement element) {
    return element.name().equals("ProtoInstance") ? element.text("name") : Optional.empty();
  }

  private static Optional<String> url(DocumentElement element, Set<String> types) {
    if (!types.contains(element.name())) {
      return Optional.empty();
    }
    return element
        .text("url")
        .map(MFStringParser::strings)
        .flatMap(urls -> urls.stream().findFirst())
        .map(FILE::matcher)
        .filter(Matcher::find)
        .map(file -> file.group(1));
  }

  /** Returns a DEF name without what only says the type of its node. */
  private static Optional<String> plain(Optional<String> def) {
    return def.map(name -> SUFFIX.matcher(PREFIX.matcher(name).replaceFirst("")).replaceFirst(""))
        .filter(name -> name.codePoints().anyMatch(Character::isLetter));
  }

  /** Returns the geometry of an element with a single Shape. */
  static Optional<DocumentElement> geometry(DocumentElement element) {
    List<DocumentElement> found =
        within(element)
            .filter(inner -> inner.name().equals("Shape"))
            .flatMap(
                shape ->
                    shape.children().stream()
                        .filter(child -> !child.name().equals("Appearance"))
                        .filter(child -> !child.name().startsWith("Metadata"))
                        .findFirst()
                        .stream())
            .limit(2)
            .toList();
    return found.size() == 1 ? Optional.of(found.get(0)) : Optional.empty();
  }

  /** Returns the first words as an identifier: {@code Office_chair}; empty for none. */
  private static String identifier(String words) {
    List<String> kept = new ArrayList<>();
    for (String word : BETWEEN_WORDS.split(words.strip())) {
      if (!word.isEmpty() && kept.size() < WORDS && !(kept.isEmpty() && article(word))) {
        kept.add(word);
      }
    }
    String name = UniqueNameGenerator.identifier(String.join("_", kept));
    if (name.isEmpty() || name.chars().allMatch(c -> c == '_' || c == '-')) {
      return "";
    }
    String begun = Character.toUpperCase(name.charAt(0)) + name.substring(1);
    return UniqueNameGenerator.allowed(begun) ? begun : "Object_" + begun;
  }

  private static boolean article(String word) {
    return Set.of("the", "a", "an").contains(word.toLowerCase(Locale.ROOT));
  }
}
