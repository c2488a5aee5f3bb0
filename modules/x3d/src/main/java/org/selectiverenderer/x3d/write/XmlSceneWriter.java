package org.selectiverenderer.x3d.write;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.write.SceneItem.Element;
import org.selectiverenderer.x3d.write.SceneItem.Value;

/** Writes a scene in X3D's XML encoding (ISO/IEC 19776-1). */
final class XmlSceneWriter {
  private final X3dWriter out = new X3dWriter();

  static String of(List<SceneItem> items) {
    XmlSceneWriter text = new XmlSceneWriter();
    text.out.declaration();
    items.forEach(text::item);
    return text.out.finish();
  }

  private void item(SceneItem item) {
    if (item instanceof SceneItem.Words words) {
      out.comment(words.text());
    } else {
      element((Element) item);
    }
  }

  private void element(Element element) {
    out.open(element.name());
    String prototype = element.name().equals("ProtoInstance") ? element.text("name") : "";
    if (!prototype.isEmpty()) {
      out.attribute("name", prototype);
    }
    out.def(element.def());
    if (!element.use().isEmpty()) {
      out.attribute("USE", element.use());
    }
    if (!element.place().usual()) {
      out.attribute("containerField", element.place().name());
    }
    for (Value value : element.values()) {
      if (prototype.isEmpty() || !value.name().equals("name")) {
        value(value);
      }
    }
    ordered(element).forEach(this::item);
    if (!element.source().isEmpty()) {
      out.code("\n" + element.source() + "\n");
    }
    out.close();
  }

  private void value(Value value) {
    FieldType type = value.type();
    boolean numbers = type != null && type.kind() != FieldType.Kind.STRING;
    if (numbers && value.text().indexOf('\n') >= 0 && plain(value.text())) {
      out.numbers(value.name(), value.text());
    } else {
      out.attribute(value.name(), value.text());
    }
  }

  /** Returns whether no character needs escaping. */
  private static boolean plain(String text) {
    return text.chars().allMatch(c -> c != '<' && c != '&' && c != '\'' && c != '\r');
  }

  /** Returns the items with IS first, but after the author-defined fields. */
  private static List<SceneItem> ordered(Element element) {
    if (element.all("IS").isEmpty()) {
      return element.items();
    }
    List<SceneItem> ordered = new ArrayList<>(element.items());
    boolean declares = element.type() != null && !element.all("field").isEmpty();
    ordered.sort(Comparator.comparingInt(item -> rank(item, declares)));
    return ordered;
  }

  private static int rank(SceneItem item, boolean declares) {
    String name = item instanceof Element element ? element.name() : "";
    return name.equals("field") && declares ? 0 : name.equals("IS") ? 1 : 2;
  }
}
