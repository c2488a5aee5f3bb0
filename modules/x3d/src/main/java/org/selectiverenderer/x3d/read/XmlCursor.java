package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.List;
import javax.xml.stream.XMLStreamConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldParseErrors;
import org.selectiverenderer.x3d.field.FieldTokenizer;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentAttribute;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.ElementLocation;
import org.selectiverenderer.x3d.source.XmlPullParser;

/**
 * A cursor over the elements of a file while it is parsed. Where the XML is truncated or not
 * well-formed, all open elements end, so that the part before is kept.
 */
final class XmlCursor implements ElementCursor {
  private final XmlPullParser xml;
  private final ReadContext reading;
  private final boolean cut;
  private final List<@Nullable ElementTextCollector> gathered = new ArrayList<>();
  private FieldParseErrors flaws = new FieldParseErrors();
  private @Nullable ElementLocation place;
  private boolean broken;

  /**
   * Creates a cursor before the root element.
   *
   * @param cut whether it has already been reported that the text is truncated
   */
  XmlCursor(XmlPullParser xml, ReadContext reading, boolean cut) {
    this.xml = xml;
    this.reading = reading;
    this.cut = cut;
    gathered.add(null);
  }

  @Override
  public boolean broken() {
    return broken;
  }

  @Override
  public boolean next() {
    place = null;
    for (int event = xml.next(); event != XmlPullParser.NONE; event = xml.next()) {
      switch (event) {
        case XMLStreamConstants.START_ELEMENT -> {
          gathered.add(null);
          return true;
        }
        case XMLStreamConstants.END_ELEMENT -> {
          gathered.remove(gathered.size() - 1);
          return false;
        }
        case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> {
          ElementTextCollector into = gathered.get(gathered.size() - 1);
          if (into != null) {
            String text = xml.text();
            int start = into.begun() || text.isBlank() ? 0 : xml.textStart();
            into.add(text, start == 0 ? null : xml.source().location(start), start);
          }
        }
        case XMLStreamConstants.ENTITY_REFERENCE ->
            reading.error(xml.place().location(), xml.entityProblem() + "; it is left out");
        default -> {
          // comments, processing instructions and the DOCTYPE are not part of the scene
        }
      }
    }
    DocumentError fault = xml.fault();
    if (fault != null) {
      breakOff(fault);
    }
    return false;
  }

  private void breakOff(DocumentError fault) {
    if (!broken && !cut) {
      reading.error(fault.location(), fault.message() + "; the part before it is kept");
    }
    broken = true;
    if (gathered.size() > 1) {
      gathered.remove(gathered.size() - 1);
    }
  }

  @Override
  public String name() {
    return xml.element();
  }

  @Override
  public ElementLocation place() {
    ElementLocation known = place;
    if (known == null) {
      known = xml.place();
      place = known;
    }
    return known;
  }

  @Override
  public int attributes() {
    return xml.attributes();
  }

  @Override
  public String attributeName(int index) {
    return xml.attributeName(index);
  }

  @Override
  public String attributeText(int index) {
    return xml.attributeText(index);
  }

  @Override
  public @Nullable Object attributeValue(int index, FieldType type) {
    boolean string = type.kind() == FieldType.Kind.STRING;
    String text = string ? xml.attributeText(index) : "";
    Object value =
        string
            ? reading.parser.parse(type, text, flaws)
            : xml.numbers(index, type, reading.parser, flaws);
    if (!flaws.isEmpty()) {
      reading.flaws(
          place(), index, attributeName(index), FieldTokenizer.leading(text), flaws.list());
      flaws = new FieldParseErrors();
    }
    return value;
  }

  @Override
  public void collectText(ElementTextCollector into) {
    gathered.set(gathered.size() - 1, into);
  }

  @Override
  public DocumentElement record() {
    ElementLocation start = place();
    DocumentElement recorded =
        new DocumentElement(
            xml.source(),
            name(),
            xml.attribute("DEF"),
            xml.attribute("USE"),
            start.offset(),
            xml.end(),
            0);
    List<DocumentAttribute> attributes = new ArrayList<>(attributes());
    for (int i = 0; i < attributes(); i++) {
      attributes.add(new DocumentAttribute(recorded, i, attributeName(i), attributeText(i)));
    }
    recorded.attributes(attributes);
    ElementTextCollector text = new ElementTextCollector();
    collectText(text);
    while (next()) {
      if (reading.spend(location()) && reading.enter(location())) {
        recorded.add(record());
        reading.leave();
      } else {
        skip();
      }
    }
    if (text.begun()) {
      recorded.addText(text.text(), text.offset());
    }
    return recorded;
  }
}
