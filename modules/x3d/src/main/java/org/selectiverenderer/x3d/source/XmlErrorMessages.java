package org.selectiverenderer.x3d.source;

import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.stream.XMLStreamException;
import org.selectiverenderer.base.problem.SourceLocation;

/** Converts the exceptions of the XML parser to messages for authors. */
final class XmlErrorMessages {
  private static final Pattern ENTITY =
      Pattern.compile("ENTITY_REFERENCE \\(([^)]*)\\)|&([^;)]*);");
  private static final Pattern EXPECTED = Pattern.compile("expected </([^>]*)>");
  private static final Pattern PREFIX = Pattern.compile("prefix '([^']*)'");

  /** The beginning of the message about a prefix that is not declared. */
  static final String PREFIX_FAULT = "the prefix ";

  /** Characters in which a reference to an entity is looked for before a fault. */
  static final int LONGEST_REFERENCE = 32;

  /** Parts of the parser's messages, and the corresponding messages for authors. */
  private static final Map<String, String> CAUSES =
      Map.of(
          "expected a quote", "the value of an attribute must be in quotes",
          "'--' not allowed", "'--' is not allowed inside a comment",
          "expected '='", "'=' and a value are expected after the name of an attribute",
          "expected space", "white space is expected between attributes",
          "processing instruction target", "<?xml ...?> is allowed only at the start of a file",
          "invalid name start character", "a letter is expected here; write '&' alone as &amp;",
          "illegal xml character", "XML does not allow this control character");

  private XmlErrorMessages() {}

  /** Returns the name of the entity that is not expanded; empty if the error is another one. */
  static String entity(XMLStreamException fault) {
    String raw = fault.getMessage() == null ? "" : fault.getMessage();
    String message = raw.toLowerCase(Locale.ROOT);
    Matcher entity = ENTITY.matcher(raw);
    boolean cut = message.contains("end-of-input") || message.contains("end of input");
    if (cut || !message.contains("entity") || !entity.find()) {
      return "";
    }
    return entity.group(1) != null ? entity.group(1) : entity.group(2);
  }

  /** Returns the message, to which the consequence can be appended. */
  static String describe(XMLStreamException fault) {
    String raw = fault.getMessage() == null ? "" : fault.getMessage();
    String message = raw.toLowerCase(Locale.ROOT);
    if (message.contains("end-of-input") || message.contains("end of input")) {
      return "the file is cut off here";
    }
    if (message.contains("entity")) {
      return "this is not a valid reference to a character";
    }
    if (message.contains("unbound namespace prefix")) {
      Matcher prefix = PREFIX.matcher(raw);
      return PREFIX_FAULT
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
      return "the XML is not well formed: '<' is not allowed inside a tag or its attribute";
    }
    for (Map.Entry<String, String> cause : CAUSES.entrySet()) {
      if (message.contains(cause.getKey())) {
        return "the XML is not well formed: " + cause.getValue();
      }
    }
    return "the XML is not well formed here";
  }

  /**
   * Returns the location of the error. The parser stops after the offending character.
   *
   * @param length the length of the parsed text
   */
  static SourceLocation place(XMLStreamException fault, TextSource source, int length) {
    javax.xml.stream.Location at = fault.getLocation();
    if (at == null) {
      return SourceLocation.of(source.file());
    }
    CharSequence text = source.characters();
    String message = String.valueOf(fault.getMessage()).toLowerCase(Locale.ROOT);
    int end = Math.max(0, Math.min(at.getCharacterOffset(), length));
    if (message.contains("end-of-input") || message.contains("end of input")) {
      return stop(at, source);
    }
    if (message.contains("expected </") || message.contains("processing instruction target")) {
      return source.location(back(text, end, '<'));
    }
    if (message.contains("duplicate attribute")) {
      return repeated(source, back(text, end, '<'));
    }
    if (message.contains("name start character") || message.contains("entity")) {
      int ampersand = back(text, end, '&');
      boolean found = ampersand < length && text.charAt(ampersand) == '&';
      if (found && end - ampersand < LONGEST_REFERENCE) {
        return source.location(ampersand);
      }
    }
    boolean ended = end > 0 && message.contains("root element");
    return source.location(ended ? back(text, end, '<') : Math.max(0, end - 1));
  }

  /** Returns the location at which the parser stopped. */
  static SourceLocation stop(javax.xml.stream.Location at, TextSource source) {
    return source.isExpanded()
        ? source.location(Math.max(0, at.getCharacterOffset()))
        : new SourceLocation(source.file(), at.getLineNumber(), at.getColumnNumber());
  }

  /** Returns the offset of the last such character before an offset, or else that offset. */
  private static int back(CharSequence text, int end, char wanted) {
    for (int i = end - 1; i >= 0; i--) {
      if (text.charAt(i) == wanted) {
        return i;
      }
    }
    return end;
  }

  /** Returns the location of the first repeated attribute of a tag. */
  private static SourceLocation repeated(TextSource source, int tag) {
    Set<String> names = new HashSet<>();
    for (SourceAttribute attribute : source.tag(tag).attributes()) {
      if (!names.add(attribute.name())) {
        return source.location(attribute.from());
      }
    }
    return source.location(tag);
  }
}
