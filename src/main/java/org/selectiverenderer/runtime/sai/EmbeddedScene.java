package org.selectiverenderer.runtime.sai;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.nodes.InlineNode;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.runtime.scene.Route;
import org.selectiverenderer.runtime.scene.Scene;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.Location;
import org.web3d.x3d.sai.ComponentInfo;
import org.web3d.x3d.sai.ImportedNodeException;
import org.web3d.x3d.sai.InvalidExecutionContextException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidProtoException;
import org.web3d.x3d.sai.InvalidReadableFieldException;
import org.web3d.x3d.sai.InvalidRouteException;
import org.web3d.x3d.sai.InvalidWritableFieldException;
import org.web3d.x3d.sai.NotSupportedException;
import org.web3d.x3d.sai.ProfileInfo;
import org.web3d.x3d.sai.X3DExternProtoDeclaration;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DProtoDeclaration;
import org.web3d.x3d.sai.X3DProtoInstance;
import org.web3d.x3d.sai.X3DRoute;
import org.web3d.x3d.sai.X3DScene;

/** A scene behind the SAI. */
final class EmbeddedScene implements X3DScene {
  private final EmbeddedBrowser browser;
  private final Scene scene;
  private final int children;
  private boolean disposed;

  EmbeddedScene(EmbeddedBrowser browser, Scene scene) {
    this.browser = browser;
    this.scene = scene;
    children = scene.root().type().indexOf("children");
  }

  Scene scene() {
    check();
    return scene;
  }

  private void check() {
    browser.check();
    if (disposed) {
      throw new InvalidExecutionContextException("the scene is disposed of");
    }
  }

  @Override
  public String getSpecificationVersion() {
    check();
    return scene.version();
  }

  @Override
  public int getEncoding() {
    check();
    return scene.url().isEmpty() ? SCRIPTED_ENCODING : XML_ENCODING;
  }

  @Override
  public @Nullable ProfileInfo getProfile() {
    check();
    try {
      return browser.getProfile(scene.profile());
    } catch (NotSupportedException e) {
      return null; // A file may leave its profile out or misspell it: the SAI has null for that.
    }
  }

  @Override
  public ComponentInfo[] getComponents() {
    check();
    return Infos.components(scene.components());
  }

  @Override
  public String getWorldURL() {
    check();
    return scene.url();
  }

  @Override
  public X3DRoute[] getRoutes() {
    check();
    return scene.routes().stream()
        .map(route -> new EmbeddedRoute(browser, route))
        .toArray(X3DRoute[]::new);
  }

  @Override
  public X3DRoute addRoute(
      X3DNode fromNode, String readableField, X3DNode toNode, String writableField) {
    check();
    Node from = browser.unwrapped(fromNode);
    Node to = browser.unwrapped(toNode);
    FieldDefinition out =
        from.type()
            .output(readableField)
            .orElseThrow(
                () -> new InvalidReadableFieldException(from + " sends no " + readableField));
    FieldDefinition in =
        to.type()
            .input(writableField)
            .orElseThrow(
                () -> new InvalidWritableFieldException(to + " receives no " + writableField));
    if (out.type() != in.type()) {
      throw new InvalidRouteException(
          "%s of %s cannot be routed to %s of %s: the types %s and %s differ"
              .formatted(out.name(), from, in.name(), to, out.type(), in.type()));
    }
    Route route = new Route(from, out.index(), to, in.index());
    browser.execute(() -> scene.addRoute(route));
    return new EmbeddedRoute(browser, route);
  }

  @Override
  public void removeRoute(X3DRoute route) {
    check();
    if (route instanceof EmbeddedRoute embedded) {
      browser.execute(() -> scene.removeRoute(embedded.route()));
    }
  }

  @Override
  public String[] getProtosNames() {
    check();
    return new String[0];
  }

  @Override
  public X3DProtoDeclaration getProtoDeclaration(String name) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void updateProtoDeclaration(String name, X3DProtoDeclaration declaration) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void removeProtoDeclaration(String name) {
    check();
  }

  @Override
  public String[] getExternProtoNames() {
    check();
    return new String[0];
  }

  @Override
  public X3DExternProtoDeclaration getExternProtoDeclaration(String name) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void updateExternProtoDeclaration(String name, X3DExternProtoDeclaration declaration) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void removeExternProtoDeclaration(String name) {
    check();
  }

  private static InvalidProtoException noPrototype(String name) {
    return new InvalidProtoException(
        "there is no prototype %s: instances are expanded while a file is read".formatted(name));
  }

  @Override
  public String[] getNamedNodes() {
    check();
    return scene.named().keySet().toArray(String[]::new);
  }

  @Override
  public X3DNode getNamedNode(String name) {
    check();
    return browser.wrap(
        scene
            .find(name)
            .or(() -> Optional.ofNullable(scene.imported().get(name)))
            .orElseThrow(() -> new InvalidNodeException("no node has the DEF name " + name)));
  }

  @Override
  public X3DNode getImportedNode(String name) {
    check();
    Node node = scene.imported().get(name);
    if (node == null) {
      throw new InvalidNodeException("no node is imported as " + name);
    }
    return browser.wrap(node);
  }

  @Override
  public void removeImportedNode(String name) {
    check();
    browser.execute(() -> scene.imported().remove(name));
  }

  @Override
  public void updateImportedNode(String exportedName, String name, X3DNode inline) {
    check();
    Node node =
        Optional.of(browser.unwrapped(inline))
            .filter(InlineNode.class::isInstance)
            .flatMap(candidate -> ((InlineNode) candidate).content())
            .flatMap(
                inner ->
                    Optional.ofNullable(inner.exports().get(exportedName)).flatMap(inner::find))
            .orElseThrow(
                () -> new ImportedNodeException("the Inline exports no node as " + exportedName));
    browser.execute(() -> scene.imported().put(name, node));
  }

  @Override
  public void updateNamedNode(String name, X3DNode node) {
    check();
    if (scene.imported().containsKey(name)) {
      throw new ImportedNodeException(name + " is the name of an imported node");
    }
    Node unwrapped = browser.unwrapped(node);
    browser.execute(() -> scene.name(name, unwrapped));
  }

  @Override
  public void removeNamedNode(String name) {
    check();
    browser.execute(() -> scene.unname(name));
  }

  @Override
  public X3DNode[] getRootNodes() {
    check();
    return scene.root().nodes("children").stream().map(browser::wrap).toArray(X3DNode[]::new);
  }

  @Override
  public X3DNode createNode(String name) {
    check();
    return browser
        .catalogue()
        .find(name)
        .map(
            type ->
                browser.wrapNew(
                    browser.factory().make(type, null, Location.of("(made by the application)"))))
        .orElseThrow(() -> new InvalidNodeException("there is no node type " + name));
  }

  @Override
  public X3DProtoInstance createProto(String name) {
    check();
    throw noPrototype(name);
  }

  @Override
  public void dispose() {
    disposed = true;
  }

  @Override
  public void addMetaData(String name, String value) {
    check();
    browser.execute(() -> scene.meta().put(name, value));
  }

  @Override
  public Map<String, String> getMetaData() {
    check();
    return new LinkedHashMap<>(scene.meta());
  }

  @Override
  public void removeMetaData(String name) {
    check();
    browser.execute(() -> scene.meta().remove(name));
  }

  @Override
  public X3DNode getExportedNode(String name) {
    check();
    return browser.wrap(
        Optional.ofNullable(scene.exports().get(name))
            .flatMap(scene::find)
            .orElseThrow(() -> new InvalidNodeException("no node is exported as " + name)));
  }

  @Override
  public String[] getExportedNodes() {
    check();
    return scene.exports().keySet().toArray(String[]::new);
  }

  @Override
  public void updateExportedNode(String name, @Nullable String exportedName) {
    check();
    if (scene.find(name).isEmpty()) {
      throw new InvalidNodeException("no node has the DEF name " + name);
    }
    String as = exportedName == null ? name : exportedName;
    browser.execute(() -> scene.exports().put(as, name));
  }

  @Override
  public void removeExportedNode(String exportedName) {
    check();
    browser.execute(() -> scene.exports().remove(exportedName));
  }

  @Override
  public void addRootNode(X3DNode node) {
    check();
    Node added = browser.unwrapped(node);
    browser.execute(
        () -> {
          List<Node> roots = new ArrayList<>(scene.root().nodes("children"));
          roots.add(added);
          browser.write(scene.root(), children, List.copyOf(roots));
        });
  }

  @Override
  public void removeRootNode(X3DNode node) {
    check();
    Node removed = browser.unwrapped(node);
    browser.execute(
        () -> {
          List<Node> roots = new ArrayList<>(scene.root().nodes("children"));
          roots.remove(removed);
          browser.write(scene.root(), children, List.copyOf(roots));
        });
  }
}
