package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;

/** Reads the document structure: the elements X3D, head, Scene, IMPORT and EXPORT. */
final class X3dElementReader implements NodeReader.Links {
  private final ReadContext reading;
  private final RouteReader routes;
  private final NodeReader nodes;
  private final NameScope scope;
  private final Map<String, Integer> components = new LinkedHashMap<>();
  private final List<X3dFile.Meta> meta = new ArrayList<>();
  private final List<X3dFile.Unit> units = new ArrayList<>();
  private final List<ParsedNode> top = new ArrayList<>();
  private final List<X3dFile.Import> imports = new ArrayList<>();
  private final List<X3dFile.Export> exports = new ArrayList<>();
  private String version = "";
  private String profile = "";

  X3dElementReader(ReadContext reading) {
    this(reading, null);
  }

  /**
   * Creates a reader of one file.
   *
   * @param around the scope whose prototypes the file may use, too
   */
  X3dElementReader(ReadContext reading, @Nullable NameScope around) {
    this.reading = reading;
    scope = new NameScope(around, null);
    this.routes = new RouteReader(reading);
    this.nodes = new NodeReader(reading, routes, this);
  }

  /** Reads a file, with the cursor before its root element. */
  X3dFile read(ElementCursor in) {
    if (in.next()) {
      if (in.name().equals("X3D")) {
        root(in);
      } else {
        reading.error(
            in.location(),
            "the root element of a scene must be X3D, not " + in.name() + "; nothing can be shown");
        in.skip();
      }
      // reports content after the root element
      in.next();
    } else if (!in.broken()) {
      reading.error(
          SourceLocation.of(reading.source()), "the file has no X3D element; nothing can be shown");
    }
    routes.connect(scope);
    exports.removeIf(this::unknown);
    return result();
  }

  private void root(ElementCursor in) {
    SourceLocation location = in.location();
    version = text(in, "version");
    profile = text(in, "profile");
    boolean scene = false;
    while (in.next()) {
      switch (in.name()) {
        case "head" -> head(in);
        case "Scene" -> {
          scene = true;
          scene(in);
        }
        default -> {
          if (!in.foreign()) {
            reading.error(
                in.location(),
                in.name() + " is outside of Scene; it and its children are left out");
          }
          in.skip();
        }
      }
    }
    if (!scene && !in.broken()) {
      reading.error(location, "the file has no Scene element; nothing can be shown");
    }
  }

  private void head(ElementCursor in) {
    while (in.next()) {
      switch (in.name()) {
        case "component" -> {
          int level = in.indexOf("level");
          Object value = level < 0 ? null : in.attributeValue(level, FieldType.SFInt32);
          components.put(text(in, "name"), value == null ? 1 : (Integer) value);
        }
        case "unit" -> {
          int factor = in.indexOf("conversionFactor");
          Object value = factor < 0 ? null : in.attributeValue(factor, FieldType.SFDouble);
          double stated = value == null ? 1 : (Double) value;
          units.add(new X3dFile.Unit(text(in, "category"), text(in, "name"), stated));
          if (text(in, "category").equals("angle")) {
            reading.angles(AngleUnit.of(stated));
          }
        }
        case "meta" -> meta.add(new X3dFile.Meta(text(in, "name"), text(in, "content")));
        default -> {
          if (!in.foreign()) {
            reading.warning(
                in.location(),
                in.name()
                    + " is not allowed in the head"
                    + reading.question(in.name(), List.of("component", "meta", "unit"))
                    + "; it is left out");
          }
        }
      }
      in.skip();
    }
  }

  private void scene(ElementCursor in) {
    while (in.next()) {
      NodeReader.Child child = nodes.read(in, scope);
      if (child != null) {
        NodeType type = child.node().type();
        boolean fits =
            type.is("X3DChildNode") || type.is("LayerSet") || type.is("X3DMetadataObject");
        if (!reading.parts() && !fits) {
          reading.warning(
              child.location(),
              SpellingSuggester.one(type.name())
                  + " at the top of a scene is not shown; put it into another node");
        }
        top.add(child.node());
      }
    }
  }

  @Override
  public void link(ElementCursor in) {
    if (in.name().equals("IMPORT")) {
      String earlier = in.attribute("exportedDEF"); // X3D 3.0 calls it so in its XML encoding.
      String imported = earlier == null ? text(in, "importedDEF") : earlier;
      String as = in.attribute("AS");
      String name = as == null ? imported : as;
      imports.add(new X3dFile.Import(text(in, "inlineDEF"), imported, name, in.location()));
      scope.addImport(name);
    } else {
      String local = text(in, "localDEF");
      String as = in.attribute("AS");
      exports.add(new X3dFile.Export(local, as == null ? local : as, in.location()));
    }
  }

  private boolean unknown(X3dFile.Export export) {
    if (scope.find(export.localDef()) != null || scope.isImported(export.localDef())) {
      return false;
    }
    if (scope.isLost(export.localDef())) {
      return true;
    }
    reading.error(
        export.location(),
        "no node has the name "
            + export.localDef()
            + reading.question(export.localDef(), scope.names().keySet())
            + "; the EXPORT is left out");
    return true;
  }

  private static String text(ElementCursor in, String attribute) {
    String value = in.attribute(attribute);
    return value == null ? "" : value;
  }

  private Map<String, X3dFile.InstanceFields> instances() {
    Map<String, X3dFile.InstanceFields> instances = new LinkedHashMap<>();
    for (X3dFile.Export export : exports) {
      NameScope.Named named = scope.find(export.localDef());
      ProtoInstance instance = named == null ? null : named.instance();
      if (named != null && instance != null) {
        instances.put(export.as(), routes.fields(named, instance));
      }
    }
    return Collections.unmodifiableMap(instances);
  }

  private X3dFile result() {
    Map<String, ParsedNode> named = new LinkedHashMap<>();
    scope.names().forEach((name, node) -> named.put(name, node.node()));
    return new X3dFile(
        reading.source(),
        version,
        profile,
        Collections.unmodifiableMap(components),
        List.copyOf(meta),
        List.copyOf(units),
        List.copyOf(top),
        List.copyOf(reading.loose()),
        Collections.unmodifiableMap(named),
        List.copyOf(routes.routes()),
        List.copyOf(imports),
        List.copyOf(exports),
        List.copyOf(routes.imported()),
        instances(),
        reading.interfaces.listing(),
        List.copyOf(reading.externFaults()),
        prototypes());
  }

  /** Returns the scene's prototypes; called last, as it clears the rest of the scope. */
  private @Nullable PrototypeLibrary prototypes() {
    scope.keepPrototypes();
    return scope.prototypeNames().isEmpty()
        ? null
        : new PrototypeLibrary(reading.source(), scope, null, List.of());
  }
}
