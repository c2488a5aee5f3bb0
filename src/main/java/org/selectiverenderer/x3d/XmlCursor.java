package org.selectiverenderer.x3d;

import java.util.ArrayList;
import java.util.List;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.LocationInfo;
import org.codehaus.stax2.XMLStreamReader2;
import org.codehaus.stax2.typed.TypedValueDecoder;
import org.jspecify.annotations.Nullable;

/**
 * Walks through the elements of a file while it is parsed. Where the XML breaks off or is not well
 * formed, all open elements end, so that what was read up to there is kept.
 */
final class XmlCursor implements ElementCursor {
  private static final char[] EMPTY = {};

  private final SourceText text;
  private final Reading reading;
  private final boolean cut;
  private final XMLStreamReader2 xml;
  private final List<@Nullable StringBuilder> gathered = new ArrayList<>();
  private final Decoder decoder = new Decoder();
  private @Nullable Place place;
  private boolean broken;

  /**
   * Starts before the root element.
   *
   * @param cut whether the end of the text has been reported as missing already
   */
  XmlCursor(SourceText text, Reading reading, boolean cut) throws XMLStreamException {
    this.text = text;
    this.reading = reading;
    this.cut = cut;
    this.xml = text.parser();
    gathered.add(null);
  }

  @Override
  public boolean broken() {
    return broken;
  }

  @Override
  public boolean next() {
    place = null;
    try {
      while (!broken && xml.hasNext()) {
        switch (xml.next()) {
          case XMLStreamConstants.START_ELEMENT -> {
            gathered.add(null);
            return true;
          }
          case XMLStreamConstants.END_ELEMENT -> {
            gathered.remove(gathered.size() - 1);
            return false;
          }
          case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> {
            StringBuilder into = gathered.get(gathered.size() - 1);
            if (into != null) {
              into.append(xml.getText());
            }
          }
          case XMLStreamConstants.ENTITY_REFERENCE ->
              reading.error(
                  place().location(),
                  "entities of a DOCTYPE are never expanded; &"
                      + xml.getLocalName()
                      + "; is left out");
          default -> {
            // Comments, processing instructions and the DOCTYPE say nothing about the scene.
          }
        }
      }
    } catch (XMLStreamException e) {
      breakOff(XmlFaults.describe(e), e.getLocation());
    } catch (RuntimeException e) {
      // Text is parsed when it is asked for, and then the parser wraps its exception. Whatever else
      // it may throw on hostile text means no more than that the text is bad.
      if (e.getCause() instanceof XMLStreamException fault) {
        breakOff(XmlFaults.describe(fault), fault.getLocation());
      } else {
        breakOff("the XML is not well formed from here on", xml.getLocation());
      }
    }
    if (broken && gathered.size() > 1) {
      gathered.remove(gathered.size() - 1);
    }
    return false;
  }

  private void breakOff(String what, javax.xml.stream.@Nullable Location at) {
    broken = true;
    if (cut) {
      return;
    }
    Location location =
        at != null
            ? new Location(reading.source(), at.getLineNumber(), at.getColumnNumber())
            : Location.of(reading.source());
    reading.error(location, what + "; what was read before is kept");
  }

  @Override
  public String name() {
    return xml.getLocalName();
  }

  @Override
  public Place place() {
    Place known = place;
    if (known == null) {
      LocationInfo info = xml.getLocationInfo();
      javax.xml.stream.Location at = info.getStartLocation();
      known =
          new Place(
              text,
              at.getCharacterOffset(),
              new Location(reading.source(), at.getLineNumber(), at.getColumnNumber()));
      place = known;
    }
    return known;
  }

  @Override
  public int attributes() {
    return xml.getAttributeCount();
  }

  @Override
  public String attributeName(int index) {
    String prefix = xml.getAttributePrefix(index);
    return prefix == null || prefix.isEmpty() ? xml.getAttributeLocalName(index) : "";
  }

  @Override
  public String attributeText(int index) {
    return xml.getAttributeValue(index);
  }

  @Override
  public @Nullable Object attributeValue(int index, FieldType type) {
    if (type.kind() == FieldType.Kind.STRING) {
      String value = xml.getAttributeValue(index);
      if (!type.multiple()) {
        return value;
      }
      Flaws flaws = new Flaws();
      Object strings = reading.parser.parse(type, value, flaws);
      if (!flaws.isEmpty()) {
        reading.flaws(place(), index, attributeName(index), Words.leading(value), flaws);
      }
      return strings;
    }
    try {
      decoder.type = type;
      xml.getAttributeAs(index, decoder);
    } catch (XMLStreamException e) {
      throw new IllegalStateException("a number's own decoder reports no such error", e);
    }
    if (!decoder.flaws.isEmpty()) {
      reading.flaws(place(), index, attributeName(index), 0, decoder.flaws);
      decoder.flaws = new Flaws();
    }
    return decoder.value;
  }

  @Override
  public void collectText(StringBuilder into) {
    gathered.set(gathered.size() - 1, into);
  }

  @Override
  public RecordedElement record() {
    RecordedElement recorded = new RecordedElement(this);
    while (next()) {
      if (reading.spend(location()) && reading.enter(location())) {
        recorded.add(record());
        reading.leave();
      } else {
        skip();
      }
    }
    return recorded;
  }

  /**
   * Takes the characters of a value from the parser's own buffer; a large value is never copied.
   */
  private final class Decoder extends TypedValueDecoder {
    private FieldType type = FieldType.SFBool;
    private @Nullable Object value;
    private Flaws flaws = new Flaws();

    @Override
    public void decode(String input) {
      decode(input.toCharArray(), 0, input.length());
    }

    @Override
    public void decode(char[] buffer, int start, int end) {
      value = reading.parser.parse(type, buffer, start, end, flaws);
    }

    @Override
    public void handleEmptyValue() {
      decode(EMPTY, 0, 0);
    }
  }
}
