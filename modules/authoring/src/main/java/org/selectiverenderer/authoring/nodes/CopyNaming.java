package org.selectiverenderer.authoring.nodes;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;

/**
 * Names the nodes of copies: all named nodes in them get names that are free, the references within
 * the copies and the metadata that is called after the nodes follow.
 */
public final class CopyNaming {
  private static final Set<String> NAMING = Set.of("DEF", "USE");
  private static final Set<String> ROUTED = Set.of("fromNode", "toNode");

  private final SceneDocument source;
  private final Map<String, String> renamed = new HashMap<>();
  private final List<TextEdit> changes = new ArrayList<>();

  private CopyNaming(SceneDocument source) {
    this.source = source;
  }

  /**
   * Returns the changes of the copies' texts, whose offsets are those of the originals.
   *
   * @param source the document of the originals
   * @param elements the originals, none within another
   * @param names gives free names
   * @param wanted names of some of the copies, which are known to be free
   */
  public static List<TextEdit> changes(
      SceneDocument source,
      List<DocumentElement> elements,
      UniqueNameGenerator names,
      Map<DocumentElement, String> wanted) {
    CopyNaming naming = new CopyNaming(source);
    wanted.forEach(naming::give);
    elements.forEach(
        element -> ElementScope.visitWithin(element, each -> naming.name(each, names)));
    elements.forEach(element -> ElementScope.visitWithin(element, naming::follow));
    return naming.changes;
  }

  private void give(DocumentElement element, String name) {
    element
        .def()
        .ifPresentOrElse(
            def -> renamed.put(def, name),
            () -> changes.add(source.layout().attribute(element, "DEF", name)));
  }

  private void name(DocumentElement element, UniqueNameGenerator names) {
    element
        .def()
        .filter(def -> !renamed.containsKey(def))
        .ifPresent(def -> renamed.put(def, names.unused(MetadataNaming.def(element, def, now()))));
  }

  private UnaryOperator<String> now() {
    return name -> renamed.getOrDefault(name, name);
  }

  private void follow(DocumentElement element) {
    source
        .tag(element)
        .attribute("name")
        .ifPresent(
            name -> {
              String now = MetadataNaming.name(element, name.value(), now());
              if (!now.equals(name.value())) {
                changes.add(source.layout().attribute(element, "name", now));
              }
            });
    QualityFieldNaming.change(source.layout(), element, now()).ifPresent(changes::add);
    for (SourceAttribute written : source.tag(element).attributes()) {
      boolean reference =
          NAMING.contains(written.name())
              || ROUTED.contains(written.name()) && element.name().equals("ROUTE");
      String now = renamed.get(written.value());
      if (reference && now != null && !now.equals(written.value())) {
        changes.add(new TextEdit(written.valueFrom(), written.valueTo(), now));
      }
    }
  }
}
