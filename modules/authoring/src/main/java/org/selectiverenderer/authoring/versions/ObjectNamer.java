package org.selectiverenderer.authoring.versions;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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
    List<Optional<String>> found = new ArrayList<>();
    found.add(comment(element));
    found.add(element.text("name"));
    found.add(first(element, inner -> url(inner, Set.of("Inline"))));
    found.add(first(element, inner -> plain(inner.def().or(inner::use))));
    found.add(first(element, ObjectNamer::prototype));
    found.add(first(element, inner -> url(inner, TEXTURES)));
    String wanted =
        found.stream()
            .flatMap(Optional::stream)
            .map(ObjectNamer::identifier)
            .filter(name -> !name.isEmpty())
            .findFirst()
            .orElseGet(() -> identifier(type(element)));
    return names.free(wanted);
  }

  /** Returns the comment directly above an element, unless it is long or holds markup. */
  private Optional<String> comment(DocumentElement element) {
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
    List<String> found = new ArrayList<>();
    element.visit(inner -> reading.of(inner).ifPresent(found::add));
    return found.stream().findFirst();
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

  /** Returns the type of the only geometry, else {@code Object}. */
  private static String type(DocumentElement element) {
    List<String> types = new ArrayList<>();
    element.visit(
        inner -> {
          if (inner.name().equals("Shape")) {
            inner.children().stream()
                .map(DocumentElement::name)
                .filter(name -> !name.equals("Appearance") && !name.startsWith("Metadata"))
                .findFirst()
                .ifPresent(types::add);
          }
        });
    return types.size() == 1 ? types.get(0) : "Object";
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
