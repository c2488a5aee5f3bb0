package org.selectiverenderer.authoring.nodes;

import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.schema.MetadataNames;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Renames metadata along with the object or area that it is called after, where its names follow
 * the convention of {@link MetadataNames}.
 */
final class MetadataNaming {
  private static final String METADATA = "Metadata";
  private static final String SET = "MetadataSet";

  private MetadataNaming() {}

  /** Returns whether an element is a metadata node. */
  static boolean isMetadata(DocumentElement element) {
    return element.name().startsWith(METADATA);
  }

  /**
   * Returns the DEF name that an element's present one becomes; the same where it is not called
   * after a renamed node.
   *
   * @param renamed returns the new DEF name for an old one, or the old one
   */
  static String def(DocumentElement element, String def, UnaryOperator<String> renamed) {
    return owner(element)
        .map(owner -> following("(?:MetadataSet_?|[A-Za-z]+Definition)", owner, def, renamed))
        .orElse(def);
  }

  /**
   * Returns what the {@code name} of an element becomes; the same where it is no set of metadata
   * that is called after a renamed node.
   *
   * @param renamed returns the new DEF name for an old one, or the old one
   */
  static String name(DocumentElement element, String name, UnaryOperator<String> renamed) {
    // The name of a MetadataString is that of a field, whatever the node is called.
    return element.name().equals(SET)
        ? owner(element).map(owner -> following("", owner, name, renamed)).orElse(name)
        : name;
  }

  /** Returns the node that metadata is about; empty for other nodes and where it has no name. */
  private static Optional<DocumentElement> owner(DocumentElement metadata) {
    DocumentElement owner = metadata;
    while (isMetadata(owner) && owner.parent().isPresent()) {
      owner = owner.parent().get();
    }
    return Optional.of(owner).filter(found -> found != metadata && found.def().isPresent());
  }

  private static String following(
      String before, DocumentElement owner, String name, UnaryOperator<String> renamed) {
    String from = owner.def().orElseThrow();
    Pattern convention =
        Pattern.compile(
            "(%s)%s(?=$|_|Definition)".formatted(before, Pattern.quote(called(owner, from))));
    Matcher matcher = convention.matcher(name);
    return matcher.lookingAt()
        ? matcher.group(1) + called(owner, renamed.apply(from)) + name.substring(matcher.end())
        : name;
  }

  /** Returns what metadata calls its owner: only the names of Switches have words around them. */
  private static String called(DocumentElement owner, String def) {
    return owner.name().equals("Switch") ? MetadataNames.object(def) : def;
  }
}
