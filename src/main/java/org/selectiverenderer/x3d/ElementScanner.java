package org.selectiverenderer.x3d;

import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.XMLStreamReader2;
import org.jspecify.annotations.Nullable;

/** Finds the elements of a text and where they stand, whatever language they are of. */
public final class ElementScanner {
  private static final int DEPTH = ReadLimits.standard().maxDepth();

  private ElementScanner() {}

  /**
   * Walks through a text, which must have one root element. Fetches nothing and expands no entity
   * of a DOCTYPE.
   *
   * @throws XmlFault at the first place where the text is not well formed, is nested deeper than a
   *     scene may be, or has a tag of more attributes than any node; what came before has been told
   */
  public static void scan(CharSequence text, ElementListener listener) throws XmlFault {
    scan(SourceText.of(text), listener);
  }

  static void scan(SourceText source, ElementListener listener) throws XmlFault {
    int flood = source.floodedTag();
    if (flood >= 0) {
      Location at = source.location("", flood);
      throw new XmlFault(at.line(), at.column(), "an element has more attributes than any node");
    }
    try {
      XMLStreamReader2 xml = source.parser();
      CurrentTag tag = new CurrentTag(source, xml);
      boolean found = false;
      int depth = 0;
      boolean ended = false;
      while (xml.hasNext()) {
        int event = xml.next();
        if (event == XMLStreamConstants.START_ELEMENT) {
          found = true;
          tag.enter();
          if (++depth > DEPTH) {
            throw new XmlFault(
                tag.line, tag.column, "elements are nested deeper than " + DEPTH + " levels");
          }
          listener.start(tag);
          ended = tag.empty;
        } else if (event == XMLStreamConstants.END_ELEMENT) {
          depth--;
          int end = xml.getLocationInfo().getStartLocation().getCharacterOffset();
          listener.end(ended ? tag.end : tagEnd(source, end));
          ended = false;
        }
      }
      if (!found) {
        throw new XmlFault(0, 0, "there is no element in it");
      }
    } catch (XMLStreamException e) {
      throw fault(source, e);
    }
  }

  /** The parser counts columns differently for bytes and characters, so they are counted here. */
  private static XmlFault fault(SourceText source, XMLStreamException e) {
    javax.xml.stream.Location at = e.getLocation();
    int offset = at == null ? -1 : at.getCharacterOffset();
    if (offset < 0) {
      return new XmlFault(0, 0, XmlFaults.describe(e), e);
    }
    Location place = source.location("", Math.min(offset, source.length()));
    return new XmlFault(place.line(), place.column(), XmlFaults.describe(e), e);
  }

  /** The offset behind the tag that begins at an offset. */
  private static int tagEnd(SourceText source, int start) {
    char quote = 0;
    for (int i = start; i < source.length(); i++) {
      char c = source.charAt(i);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        return i + 1;
      }
    }
    return source.length();
  }

  private static final class CurrentTag implements ElementListener.Tag {
    private final SourceText source;
    private final XMLStreamReader2 xml;
    private int start;
    private int end;
    private int line;
    private int column;
    private boolean empty;

    CurrentTag(SourceText source, XMLStreamReader2 xml) {
      this.source = source;
      this.xml = xml;
    }

    void enter() throws XMLStreamException {
      javax.xml.stream.Location at = xml.getLocationInfo().getStartLocation();
      start = at.getCharacterOffset();
      line = at.getLineNumber();
      column = at.getColumnNumber();
      empty = xml.isEmptyElement();
      end = tagEnd(source, start);
    }

    @Override
    public String name() {
      return xml.getLocalName();
    }

    @Override
    public int start() {
      return start;
    }

    @Override
    public int end() {
      return end;
    }

    @Override
    public boolean empty() {
      return empty;
    }

    @Override
    public int line() {
      return line;
    }

    @Override
    public int column() {
      return column;
    }

    @Override
    public @Nullable String attribute(String name) {
      for (int i = 0; i < xml.getAttributeCount(); i++) {
        if (xml.getAttributeLocalName(i).equals(name)) {
          return xml.getAttributeValue(i);
        }
      }
      return null;
    }
  }
}
