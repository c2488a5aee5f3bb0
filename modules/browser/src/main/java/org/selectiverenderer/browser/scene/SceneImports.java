package org.selectiverenderer.browser.scene;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The imports of a scene from the scenes of its Inlines: names of their nodes, and routes to and
 * from them (X3D 4.0, 4.4.6). The content of an Inline may arrive, change or disappear while the
 * world runs; then the names refer to other nodes, and the routes are replaced or removed.
 *
 * <p>Belongs to the thread that steps the world.
 */
public final class SceneImports {
  /** An IMPORT statement. */
  public record Declared(String inlineDef, String exported, String as, SourceLocation location) {}

  /** One end of a ROUTE. */
  public sealed interface End {
    record Own(Node node, int field) implements End {}

    /**
     * @param field the field as the ROUTE spells it
     */
    record Imported(String name, String field) implements End {}
  }

  /** A ROUTE with an imported end. */
  public record Link(End from, End to, SourceLocation location) {}

  // Lists of their own from the first element on: most scenes of Inlines import nothing.
  private List<Import> imports = List.of();
  private List<LiveLink> links = List.of();

  private static final class Import {
    final Declared declared;

    /** The scene last searched; null before the first search, and while the Inline is empty. */
    @Nullable Scene content;

    @Nullable Node node;

    Import(Declared declared) {
      this.declared = declared;
    }
  }

  private static final class LiveLink {
    final Link link;
    List<Route> routes = List.of();

    /** The nodes for which the routes were made. */
    List<@Nullable Node> ends = List.of();

    LiveLink(Link link) {
      this.link = link;
    }
  }

  public boolean isEmpty() {
    return imports.isEmpty();
  }

  public void add(Declared declared) {
    imports = imports.isEmpty() ? new ArrayList<>() : imports;
    imports.add(new Import(declared));
  }

  public void add(Link link) {
    links = links.isEmpty() ? new ArrayList<>() : links;
    links.add(new LiveLink(link));
  }

  /**
   * Updates names and routes.
   *
   * @param scene the scene whose imports these are
   * @param contents returns the scene in a node; empty if the node is no Inline or has no content
   *     now
   * @param wrong receives a message if an Inline lacks an exported node, once for each content
   * @return whether anything has changed, so that scenes that import from this one must be updated
   */
  public boolean refresh(
      Scene scene,
      Function<Node, Optional<Scene>> contents,
      BiConsumer<SourceLocation, String> wrong) {
    boolean changed = false;
    for (Import wanted : imports) {
      changed |= find(wanted, scene, contents, wrong);
    }
    for (LiveLink link : links) {
      connect(link, scene, wrong);
    }
    return changed;
  }

  private static boolean find(
      Import wanted,
      Scene scene,
      Function<Node, Optional<Scene>> contents,
      BiConsumer<SourceLocation, String> wrong) {
    Declared declared = wanted.declared;
    Scene content = scene.find(declared.inlineDef()).flatMap(contents).orElse(null);
    Node node = content == null ? null : content.exported(declared.exported()).orElse(null);
    if (content != null && node == null && content != wanted.content) {
      if (!content.imports().declares(content.exports().get(declared.exported()))) {
        wrong.accept(
            declared.location(),
            "the Inline exports no node as %s (Inline %s); the IMPORT is left out"
                .formatted(declared.exported(), declared.inlineDef()));
      }
    }
    wanted.content = content;
    if (node == wanted.node) {
      return false;
    }
    wanted.node = node;
    if (node == null) {
      scene.removeImported(declared.as());
    } else {
      scene.putImported(declared.as(), node);
    }
    return true;
  }

  /** Returns whether an IMPORT declares a name, even if its node is not available. */
  private boolean declares(@Nullable String name) {
    return imports.stream().anyMatch(each -> each.declared.as().equals(name));
  }

  private void connect(LiveLink live, Scene scene, BiConsumer<SourceLocation, String> wrong) {
    List<@Nullable Node> ends = new ArrayList<>();
    ends.add(node(live.link.from(), scene));
    ends.add(node(live.link.to(), scene));
    if (ends.equals(live.ends)) {
      return;
    }
    live.routes.forEach(scene::removeRoute);
    live.ends = ends;
    live.routes = ends.contains(null) ? List.of() : routes(live.link, scene, wrong);
    live.routes.forEach(scene::addRoute);
  }

  private static @Nullable Node node(End end, Scene scene) {
    return end instanceof End.Own own
        ? own.node()
        : scene.imported().get(((End.Imported) end).name());
  }

  private List<Route> routes(Link link, Scene scene, BiConsumer<SourceLocation, String> wrong) {
    List<End.Own> sources = fields(link.from(), false, scene, link, wrong);
    List<End.Own> targets =
        sources.isEmpty() ? List.of() : fields(link.to(), true, scene, link, wrong);
    List<Route> routes = new ArrayList<>();
    for (End.Own from : sources) {
      for (End.Own to : targets) {
        FieldDefinition sent = from.node().type().fields().get(from.field());
        FieldDefinition taken = to.node().type().fields().get(to.field());
        if (sent.type() == taken.type()) {
          routes.add(new Route(from.node(), from.field(), to.node(), to.field()));
        } else {
          wrong.accept(
              link.location(),
              "%s is %s and %s is %s; the ROUTE is left out"
                  .formatted(sent.name(), sent.type(), taken.name(), taken.type()));
        }
      }
    }
    return routes;
  }

  private List<End.Own> fields(
      End end, boolean input, Scene scene, Link link, BiConsumer<SourceLocation, String> wrong) {
    if (end instanceof End.Own own) {
      return List.of(own);
    }
    End.Imported imported = (End.Imported) end;
    Optional<ExportedInstance> instance =
        imports.stream()
            .filter(each -> each.declared.as().equals(imported.name()) && each.content != null)
            .findFirst()
            .flatMap(each -> each.content.exportedInstance(each.declared.exported()));
    if (instance.isPresent()) {
      List<End.Own> found =
          (input ? instance.get().inputs() : instance.get().outputs()).get(imported.field());
      if (found != null) {
        return found;
      }
    }
    Node node = scene.imported().get(imported.name());
    NodeType type = node.type();
    Optional<FieldDefinition> field =
        instance.isPresent()
            ? Optional.empty()
            : input ? type.input(imported.field()) : type.output(imported.field());
    if (field.isEmpty()) {
      wrong.accept(
          link.location(),
          "the imported %s (%s) has no field %s that %s events; the ROUTE is left out"
              .formatted(
                  imported.name(), type.name(), imported.field(), input ? "receives" : "sends"));
    }
    return field.map(found -> List.of(new End.Own(node, found.index()))).orElse(List.of());
  }

  /**
   * The connections of the fields of an exported prototype instance, by every field name that a
   * ROUTE may use.
   */
  public record ExportedInstance(
      Map<String, List<End.Own>> inputs, Map<String, List<End.Own>> outputs) {
    public ExportedInstance {
      inputs = new LinkedHashMap<>(inputs);
      outputs = new LinkedHashMap<>(outputs);
    }
  }
}
