package org.selectiverenderer.browser.script;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.LambdaFunction;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.browser.loading.LoadedScene;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.Scene;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The global objects {@code Browser} (ISO/IEC 19777-1, 7.2; VRML97, C.6.3), {@code print} and
 * {@code console} of scripts.
 */
final class BrowserObject {
  private static final String NAME = "Selective Renderer embedded browser";

  private final RhinoEngine engine;
  private final ScriptScheduler scripts;
  private final ScriptHost world;
  private String description = "";

  BrowserObject(RhinoEngine engine, ScriptScheduler scripts, ScriptHost world) {
    this.engine = engine;
    this.scripts = scripts;
    this.world = world;
  }

  /** Defines the objects in the scope that all scripts share. */
  void define(Context context, ScriptableObject scope) {
    HostObject browser = new HostObject("X3DBrowser", scope);
    about(browser);
    scenes(browser, scope);
    output(browser);
    ScriptableObject.defineProperty(scope, "Browser", browser, ScriptableObject.DONTENUM);
    scope.defineProperty(
        "X3DExecutionContext", () -> context(scope), null, ScriptableObject.DONTENUM);
    HostObject console = new HostObject("Console", scope);
    for (String name : List.of("log", "info", "warn", "error", "debug")) {
      console.action(name, 0, this::println);
    }
    ScriptableObject.defineProperty(scope, "console", console, ScriptableObject.DONTENUM);
    LambdaFunction print =
        new LambdaFunction(
            scope,
            "print",
            1,
            (cx, from, self, args) -> {
              println(args);
              return Undefined.instance;
            });
    ScriptableObject.defineProperty(scope, "print", print, ScriptableObject.DONTENUM);
  }

  private void about(HostObject browser) {
    String version =
        Optional.ofNullable(BrowserObject.class.getPackage().getImplementationVersion())
            .orElse("development");
    browser.property("name", () -> NAME);
    browser.method("getName", 0, args -> NAME);
    browser.property("version", () -> version);
    browser.method("getVersion", 0, args -> version);
    browser.property("currentSpeed", scripts::speed);
    browser.method("getCurrentSpeed", 0, args -> scripts.speed());
    browser.property("currentFrameRate", scripts::framesPerSecond);
    browser.method("getCurrentFrameRate", 0, args -> scripts.framesPerSecond());
    browser.method("getCurrentTime", 0, args -> world.cascade().time());
    browser.method("getWorldURL", 0, args -> world.scene().url());
    browser.property("description", () -> description, text -> description = HostObject.text(text));
    browser.action("setDescription", 1, args -> description = HostObject.text(args[0]));
    // All properties are undefined, because a world may run with or without a renderer.
    browser.method("getRenderingProperty", 1, args -> Undefined.instance);
    browser.method("getBrowserProperty", 1, args -> Undefined.instance);
    browser.method("getBrowserOption", 1, args -> Undefined.instance);
    browser.action("setBrowserOption", 2, args -> {}); // An extension of Titania and X_ITE.
    browser.action("beginUpdate", 0, args -> {});
    browser.action("endUpdate", 0, args -> {});
  }

  private void scenes(HostObject browser, Scriptable scope) {
    browser.property("currentScene", () -> context(scope));
    browser.method("getExecutionContext", 0, args -> context(scope));
    browser.method(
        "createX3DFromString", 1, args -> scene(fromText(HostObject.text(args[0])), scope));
    browser.method("createVrmlFromString", 1, args -> roots(fromText(HostObject.text(args[0]))));
    browser.method(
        "createX3DFromURL",
        1,
        args -> args.length >= 3 ? fromUrl(args) : scene(fromUrlNow(args[0]), scope));
    browser.method("createVrmlFromURL", 3, this::fromUrl);
    browser.action("replaceWorld", 1, args -> world.show(shown(args[0])));
    browser.action("loadURL", 1, args -> world.follow(engine.running().node(), urls(args[0])));
    browser.method("addRoute", 4, args -> context(scope).addRoute(args));
    browser.action("deleteRoute", 1, args -> context(scope).deleteRoute(args));
  }

  private SceneObject context(Scriptable scope) {
    RunningScript script = engine.running();
    return script.contextObject(() -> scene(script.context(), scope));
  }

  private SceneObject scene(Scene of, Scriptable scope) {
    return new SceneObject(of, engine, world.files(), scope);
  }

  private @Nullable Object roots(Scene scene) {
    return engine.values().toScript(FieldType.MFNode, scene.root().nodes("children"), null);
  }

  private Scene fromText(String text) {
    Scene made =
        world
            .files()
            .text(engine.running().node(), text)
            .orElseThrow(() -> ScriptRuntime.typeError("the text holds no scene that can be read"))
            .scene();
    made.root().nodes("children").forEach(node -> engine.running().nodes().own(node));
    return made;
  }

  private String[] urls(Object argument) {
    return argument instanceof Scriptable
        ? (String[]) engine.values().toField(FieldType.MFString, argument)
        : new String[] {HostObject.text(argument)};
  }

  private Scene fromUrlNow(Object argument) {
    return world
        .files()
        .readNow(engine.running().node(), urls(argument))
        .orElseThrow(() -> ScriptRuntime.typeError("none of the urls can be read"))
        .scene();
  }

  /**
   * Implements {@code createX3DFromURL(url, node, event)}: the nodes are sent to a field of the
   * node when they have been loaded.
   */
  private Object fromUrl(Object[] args) {
    Node node = RouteEndpoints.node(args[1]);
    String name = HostObject.text(args[2]);
    FieldDefinition field =
        node.type()
            .input(name)
            .filter(found -> found.type() == FieldType.MFNode)
            .orElseThrow(
                () -> ScriptRuntime.typeError(node + " has no MFNode input field " + name));
    Consumer<LoadedScene> arrived =
        loaded ->
            world.cascade().send(node, field.index(), loaded.scene().root().nodes("children"));
    world.files().read(engine.running().node(), urls(args[0]), arrived);
    return Undefined.instance;
  }

  private LoadedScene shown(Object argument) {
    engine.running().nodes().complete();
    if (argument instanceof SceneObject scene) {
      return world.files().loaded(scene.scene());
    }
    Object nodes = engine.values().toField(FieldType.MFNode, argument);
    return world.files().loaded((List<?>) nodes);
  }

  private void output(HostObject browser) {
    browser.action("print", 0, this::println);
    browser.action("println", 0, this::println);
  }

  /** Prints the arguments, separated by spaces, on lines of their own. */
  private void println(Object[] args) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < args.length; i++) {
      text.append(i == 0 ? "" : " ").append(HostObject.text(args[i]));
    }
    text.toString().lines().forEach(engine.running()::print);
  }
}
