package example;

import java.lang.reflect.Proxy;
import java.util.Map;
import org.web3d.x3d.sai.ExternalBrowser;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DScene;
import org.web3d.x3d.sai.core.MetadataSet;
import org.web3d.x3d.sai.core.MetadataString;
import org.web3d.x3d.sai.environmentalsensor.ProximitySensor;
import org.web3d.x3d.sai.grouping.Group;
import org.web3d.x3d.sai.grouping.Switch;

/**
 * What the controller asks of a browser, and no more: a scene of one area and one object, whose
 * nodes tell of changes. It shows nothing.
 */
final class TinyBrowser {
  /** Of the two versions the second is the one with few polygons. */
  private static final int SIMPLE = 1;

  private final TinyNode desk =
      new TinyNode(
          ProximitySensor.class,
          "metadata",
          set(schemas("enterTimeSchema", "DeskSchema"), schemas("exitTimeSchema", "OfficeSchema")),
          "isActive",
          false,
          "enterTime",
          0.0,
          "exitTime",
          0.0);
  private final TinyNode trashCan =
      new TinyNode(
          Switch.class,
          "metadata",
          set(
              set(schemas("schemaBelonginess", "DeskSchema")),
              set(schemas("schemaBelonginess", "OfficeSchema"))),
          "children",
          new X3DNode[] {version(), version()},
          "whichChoice",
          SIMPLE);
  private final Map<String, X3DNode> named =
      Map.of("Desk", desk.asNode(), "TrashCan", trashCan.asNode());

  private static X3DNode version() {
    return new TinyNode(Group.class, "children", new X3DNode[0]).asNode();
  }

  private static X3DNode set(X3DNode... members) {
    return new TinyNode(MetadataSet.class, "name", "", "value", members).asNode();
  }

  private static X3DNode schemas(String name, String... names) {
    return new TinyNode(MetadataString.class, "name", name, "value", names).asNode();
  }

  /** The browser as programs see it. */
  ExternalBrowser external() {
    X3DScene scene =
        (X3DScene)
            Proxy.newProxyInstance(
                TinyBrowser.class.getClassLoader(),
                new Class<?>[] {X3DScene.class},
                (proxy, method, arguments) ->
                    switch (method.getName()) {
                      case "getRootNodes" -> new X3DNode[] {desk.asNode(), trashCan.asNode()};
                      case "getNamedNodes" -> named.keySet().toArray(new String[0]);
                      case "getNamedNode" -> named.get((String) arguments[0]);
                      default -> throw new UnsupportedOperationException(method.getName());
                    });
    return (ExternalBrowser)
        Proxy.newProxyInstance(
            TinyBrowser.class.getClassLoader(),
            new Class<?>[] {ExternalBrowser.class},
            (proxy, method, arguments) ->
                switch (method.getName()) {
                  case "getExecutionContext" -> scene;
                  // It never shows another scene, so there is nothing to tell.
                  case "addBrowserListener", "removeBrowserListener" -> null;
                  default -> throw new UnsupportedOperationException(method.getName());
                });
  }

  /** The viewer comes to the desk. */
  void enterDesk(double time) {
    desk.set("isActive", true, time);
    desk.set("enterTime", time, time);
  }

  /** The viewer goes away from it. */
  void leaveDesk(double time) {
    desk.set("isActive", false, time);
    desk.set("exitTime", time, time);
  }
}
