package org.selectiverenderer.x3d;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** An element of a prototype, kept so that every instance can walk through it. */
final class RecordedElement {
  private final String name;
  private final Place place;
  private final String[] attributeNames;
  private final String[] attributeTexts;
  private final @Nullable FieldType[] valueTypes;
  private final @Nullable Object[] values;
  private final List<RecordedElement> children = new ArrayList<>(2);
  private final StringBuilder text = new StringBuilder(0);

  /** Records the tag of a cursor's current element. */
  RecordedElement(ElementCursor cursor) {
    name = cursor.name();
    place = cursor.place();
    int count = cursor.attributes();
    attributeNames = new String[count];
    attributeTexts = new String[count];
    valueTypes = new FieldType[count];
    values = new Object[count];
    for (int i = 0; i < count; i++) {
      attributeNames[i] = cursor.attributeName(i);
      attributeTexts[i] = cursor.attributeText(i);
    }
    cursor.collectText(text);
  }

  void add(RecordedElement child) {
    children.add(child);
  }

  List<RecordedElement> children() {
    return children;
  }

  /** A walk whose current element is this one. */
  ElementCursor cursor(Reading reading) {
    return new Cursor(this, reading);
  }

  private static final class Cursor implements ElementCursor {
    private final Reading reading;
    private final List<RecordedElement> path = new ArrayList<>();
    private final List<Integer> positions = new ArrayList<>();
    private RecordedElement current;

    Cursor(RecordedElement start, Reading reading) {
      this.reading = reading;
      current = start;
      enter(start);
    }

    private void enter(RecordedElement element) {
      path.add(element);
      positions.add(0);
      current = element;
    }

    @Override
    public boolean next() {
      int top = path.size() - 1;
      RecordedElement parent = path.get(top);
      int position = positions.get(top);
      if (position < parent.children.size()) {
        positions.set(top, position + 1);
        enter(parent.children.get(position));
        return true;
      }
      path.remove(top);
      positions.remove(top);
      return false;
    }

    @Override
    public String name() {
      return current.name;
    }

    @Override
    public Place place() {
      return current.place;
    }

    @Override
    public int attributes() {
      return current.attributeNames.length;
    }

    @Override
    public String attributeName(int index) {
      return current.attributeNames[index];
    }

    @Override
    public String attributeText(int index) {
      return current.attributeTexts[index];
    }

    @Override
    public @Nullable Object attributeValue(int index, FieldType type) {
      if (current.valueTypes[index] != type) {
        Flaws flaws = new Flaws();
        String text = current.attributeTexts[index];
        current.values[index] = reading.parser.parse(type, text, flaws);
        current.valueTypes[index] = type;
        if (!flaws.isEmpty()) {
          reading.flaws(
              current.place, index, current.attributeNames[index], Words.leading(text), flaws);
        }
      }
      return current.values[index];
    }

    @Override
    public void collectText(StringBuilder into) {
      into.append(current.text);
    }

    @Override
    public RecordedElement record() {
      RecordedElement recorded = current;
      skip();
      return recorded;
    }
  }
}
