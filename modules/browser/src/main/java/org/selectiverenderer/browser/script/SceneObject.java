package org.selectiverenderer.browser.script;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.loading.RunningSceneLoader;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.browser.script.value.NodeValue;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The {@code X3DScene} and {@code X3DExecutionContext} object of scripts (ISO/IEC 19777-1, 7.4).
 */
@SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
final class SceneObject extends HostObject {
  private final transient Scene scene;
  private final transient RhinoEngine engine;
  private final transient RunningSceneLoader files;
  private final transient FieldDefinition children;

  SceneObject(Scene scene, RhinoEngine engine, RunningSceneLoader files, Scriptable scope) {
    super("X3DScene", scope);
    this.scene = scene;
    this.engine = engine;
    this.files = files;
    children = scene.root().type().field("children").orElseThrow();
    property("specificationVersion", scene::version);
    property("encoding", () -> scene.url().isEmpty() ? "SCRIPTED" : "XML");
    property("profile", scene::profile);
    property("worldURL", scene::url);
    property("rootNodes", this::rootNodes, this::setRootNodes);
    property("routes", this::routes);
    nodes();
    names();
    method("addRoute", 4, this::addRoute);
    action("deleteRoute", 1, this::deleteRoute);
    method("toXMLString", 0, args -> NodeSerializer.xml(completed()));
    method("toVRMLString", 0, args -> NodeSerializer.classic(completed(), files.catalogue()));
    method("getMetaData", 1, args -> scene.meta().get(text(args[0])));
    action("setMetaData", 2, args -> scene.putMeta(text(args[0]), text(args[1])));
  }

  Scene scene() {
    return scene;
  }

  /** Returns the scene with all that the running script has written to nodes that it made. */
  private Scene completed() {
    engine.running().nodes().complete();
    return scene;
  }

  private void nodes() {
    method("createNode", 1, args -> createNode(text(args[0])));
    method("createProto", 1, args -> createProto(text(args[0])));
    action("addRootNode", 1, args -> changeRoots(roots -> roots.add(RouteEndpoints.body(args[0]))));
    action(
        "removeRootNode",
        1,
        args -> changeRoots(roots -> roots.remove(RouteEndpoints.body(args[0]))));
  }

  private void names() {
    method("getNamedNode", 1, args -> named(text(args[0])));
    method("getImportedNode", 1, args -> named(text(args[0])));
    method("getExportedNode", 1, args -> exported(text(args[0])));
    action("updateNamedNode", 2, args -> scene.name(text(args[0]), RouteEndpoints.body(args[1])));
    action("removeNamedNode", 1, args -> scene.unname(text(args[0])));
  }

  private Object createNode(String type) {
    Node made =
        files
            .make(engine.running().node(), type, SourceLocation.of("(made by a Script)"))
            .orElseThrow(() -> ScriptRuntime.typeError("there is no node type " + type));
    return engine.values().node(engine.running().nodes().own(made));
  }

  private Object createProto(String prototype) {
    Scene made =
        files
            .instance(scene, prototype)
            .orElseThrow(
                () -> ScriptRuntime.typeError("no prototype of the scene is called " + prototype));
    List<Node> nodes = made.root().nodes("children");
    if (nodes.isEmpty()) {
      throw ScriptRuntime.typeError("no instance of " + prototype + " can be made");
    }
    NodeValue instance = engine.values().node(nodes.get(0));
    engine.running().nodes().own(instance.node());
    return instance;
  }

  private Object named(String name) {
    return scene
        .find(name)
        .or(() -> Optional.ofNullable(scene.imported().get(name)))
        .map(node -> (Object) engine.values().node(node))
        .orElseThrow(() -> ScriptRuntime.typeError("no node has the DEF name " + name));
  }

  private Object exported(String name) {
    return Optional.ofNullable(scene.exports().get(name))
        .flatMap(scene::find)
        .map(node -> (Object) engine.values().node(node))
        .orElseThrow(() -> ScriptRuntime.typeError("no node is exported as " + name));
  }

  private @Nullable Object rootNodes() {
    return engine.running().nodes().read(scene.root(), children, children);
  }

  private void setRootNodes(@Nullable Object value) {
    engine
        .running()
        .nodes()
        .write(scene.root(), children, engine.values().toField(FieldType.MFNode, value));
  }

  private void changeRoots(Predicate<List<Object>> change) {
    Object present = engine.values().toField(FieldType.MFNode, rootNodes());
    List<Object> roots = new ArrayList<>((List<?>) present);
    if (change.test(roots)) {
      engine.running().nodes().write(scene.root(), children, List.copyOf(roots));
    }
  }

  private Object routes() {
    Object[] all =
        scene.routes().stream()
            .map(route -> new RouteObject(route, engine, getParentScope()))
            .toArray();
    return Context.getCurrentContext().newArray(getParentScope(), all);
  }

  /** Adds a route and returns it. */
  Object addRoute(Object[] args) {
    RouteObject route = new RouteObject(RouteEndpoints.route(args), engine, getParentScope());
    scene.addRoute(route.route());
    return route;
  }

  /** Removes a route, given as an object or by the four arguments that describe one. */
  void deleteRoute(Object[] args) {
    if (args[0] instanceof RouteObject given) {
      scene.removeRoute(given.route());
    } else if (args.length >= 4) {
      scene.removeRoute(RouteEndpoints.route(args));
    } else {
      throw ScriptRuntime.typeError("deleteRoute needs a route, or the nodes and fields of one");
    }
  }
}
