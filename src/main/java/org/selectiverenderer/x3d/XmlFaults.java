package org.selectiverenderer.x3d;

import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.stream.XMLStreamException;
import org.jspecify.annotations.Nullable;

/** Says in plain words what the XML parser found wrong. */
final class XmlFaults {
  private static final Pattern ENTITY =
      Pattern.compile("ENTITY_REFERENCE \\(([^)]*)\\)|&([^;)]*);");
  private static final Pattern EXPECTED = Pattern.compile("expected </([^>]*)>");
  private static final Pattern PREFIX = Pattern.compile("prefix '([^']*)'");

  private static final int LONGEST_REFERENCE = 32;

  /** What the parser says, and what it means for who writes the file. */
  private static final Map<String, String> CAUSES =
      Map.of(
          "expected a quote", "the value of an attribute stands in quotes",
          "'--' not allowed", "'--' stands within a comment",
          "expected '='", "'=' and a value are expected after the name of an attribute",
          "expected space", "white space is expected between attributes",
          "processing instruction target", "<?xml ...?> stands at the very start of a file only",
          "invalid name start character", "a letter is expected here; '&' alone is written &amp;",
          "illegal xml character", "XML cannot hold this control character");

  private XmlFaults() {}

  /** The fault as the first half of a sentence. */
  static String describe(XMLStreamException fault) {
    String raw = fault.getMessage() == null ? "" : fault.getMessage();
    String message = raw.toLowerCase(Locale.ROOT);
    if (message.contains("end-of-input") || message.contains("end of input")) {
      return "the file is cut off here";
    }
    if (message.contains("entity")) {
      Matcher entity = ENTITY.matcher(raw);
      return entity.find()
          ? "entities of a DOCTYPE are never expanded, and &"
              + (entity.group(1) != null ? entity.group(1) : entity.group(2))
              + "; is one"
          : "this is no valid reference to a character";
    }
    if (message.contains("unbound namespace prefix")) {
      Matcher prefix = PREFIX.matcher(raw);
      return "the prefix "
          + (prefix.find() ? prefix.group(1) : "here")
          + " is not declared by an xmlns attribute";
    }
    Matcher expected = EXPECTED.matcher(raw);
    if (expected.find()) {
      return "the XML is not well formed: </" + expected.group(1) + "> is expected here";
    }
    if (message.contains("duplicate attribute")) {
      return "the XML is not well formed: an attribute is given twice";
    }
    if (message.contains("second root element") || message.contains("epilog")) {
      return "the XML is not well formed: something follows the end of the root element";
    }
    if (message.contains("'<' not allowed") || message.contains("missing closing '>'")) {
      return "the XML is not well formed: '<' stands within a tag or its attribute";
    }
    for (Map.Entry<String, String> cause : CAUSES.entrySet()) {
      if (message.contains(cause.getKey())) {
        return "the XML is not well formed: " + cause.getValue();
      }
    }
    return "the XML is not well formed here";
  }

  /**
   * Where the fault is. The parser stops behind the character that it cannot take.
   *
   * @return null where the parser does not say
   */
  static @Nullable Location place(XMLStreamException fault, SourceText text, String file) {
    javax.xml.stream.Location at = fault.getLocation();
    if (at == null) {
      return null;
    }
    String message = String.valueOf(fault.getMessage()).toLowerCase(Locale.ROOT);
    int end = Math.max(0, Math.min(at.getCharacterOffset(), text.length()));
    if (message.contains("end-of-input") || message.contains("end of input")) {
      return new Location(file, at.getLineNumber(), at.getColumnNumber());
    }
    if (message.contains("expected </") || message.contains("processing instruction target")) {
      return text.location(file, back(text, end, '<'));
    }
    if (message.contains("duplicate attribute")) {
      return repeated(text, back(text, end, '<'), file);
    }
    if (message.contains("name start character") || message.contains("entity")) {
      int ampersand = back(text, end, '&');
      if (end - ampersand < LONGEST_REFERENCE && text.charAt(ampersand) == '&') {
        return text.location(file, ampersand);
      }
    }
    boolean ended = end > 0 && message.contains("root element");
    return text.location(file, ended ? back(text, end, '<') : Math.max(0, end - 1));
  }

  /** The last such character before an offset; the offset itself where there is none. */
  private static int back(SourceText text, int end, char wanted) {
    for (int i = end - 1; i >= 0; i--) {
      if (text.charAt(i) == wanted) {
        return i;
      }
    }
    return end;
  }

  /** The first attribute of a tag whose name an earlier one has. */
  private static Location repeated(SourceText text, int tag, String file) {
    Location start = text.location(file, tag);
    Place place = new Place(text, tag, start);
    Set<String> names = new HashSet<>();
    for (int i = 0; i < SourceText.ATTRIBUTES; i++) {
      String name = place.attributeName(i);
      if (name.isEmpty() || !names.add(name)) {
        return name.isEmpty() ? start : place.attribute(i);
      }
    }
    return start;
  }
}
