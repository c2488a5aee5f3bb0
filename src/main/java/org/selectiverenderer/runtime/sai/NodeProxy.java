package org.selectiverenderer.runtime.sai;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.FieldAccess;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.FieldType;
import org.web3d.x3d.sai.InvalidFieldException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidOperationTimingException;
import org.web3d.x3d.sai.InvalidWritableFieldException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldDefinition;
import org.web3d.x3d.sai.X3DNode;

/**
 * A node behind the interface of its type. Methods are read by the naming rule that the SAI package
 * states: {@code getX}, {@code setX}, {@code getNumX}.
 */
final class NodeProxy implements InvocationHandler {
  private final EmbeddedBrowser browser;
  private final Node node;
  private final X3DNode proxy;
  private final @Nullable FieldProxy[] fields;
  private boolean realized;
  private boolean disposed;

  /**
   * @param realized whether the node is part of a scene: its initializeOnly fields are fixed
   */
  NodeProxy(EmbeddedBrowser browser, Node node, boolean realized) {
    this.browser = browser;
    this.node = node;
    this.realized = realized;
    fields = new FieldProxy[node.type().fields().size()];
    proxy =
        (X3DNode)
            Proxy.newProxyInstance(
                X3DNode.class.getClassLoader(), browser.types().interfacesOf(node.type()), this);
  }

  Node node() {
    return node;
  }

  X3DNode proxy() {
    return proxy;
  }

  void realize() {
    realized = true;
  }

  @Override
  public @Nullable Object invoke(Object self, Method method, Object @Nullable [] arguments) {
    Object[] a = arguments == null ? new Object[0] : arguments;
    switch (method.getName()) {
      case "equals":
        return self == a[0];
      case "hashCode":
        return System.identityHashCode(self);
      case "toString":
        return node.toString();
      default:
        break;
    }
    if (disposed) {
      throw new InvalidNodeException(node + " is disposed of");
    }
    browser.check();
    return switch (method.getName()) {
      case "getNodeName" -> node.type().name();
      case "getNodeType", "getImplementationTypes" -> SaiTypes.nodeTypes(node.type());
      case "getFieldDefinitions" ->
          node.type().fields().stream()
              .map(EmbeddedFieldDefinition::new)
              .toArray(X3DFieldDefinition[]::new);
      case "getField" -> field((String) a[0]);
      case "realize" -> {
        realized = true;
        yield null;
      }
      case "isRealized" -> realized;
      case "dispose" -> {
        disposed = true;
        yield null;
      }
      default -> access(method, a);
    };
  }

  private X3DField field(String name) {
    FieldDefinition definition =
        node.type()
            .field(name)
            .or(() -> node.type().input(name))
            .or(() -> node.type().output(name))
            .orElseThrow(
                () -> new InvalidFieldException(node.type().name() + " has no field " + name));
    FieldProxy field = fields[definition.index()];
    if (field == null) {
      field = new FieldProxy(browser, this, definition);
      fields[definition.index()] = field;
    }
    return field.proxy();
  }

  private @Nullable Object access(Method method, Object[] a) {
    String name = method.getName();
    if (name.equals("addChildren") || name.equals("removeChildren")) {
      FieldDefinition field = node.type().fields().get(node.type().indexOf(name));
      write(field, browser.values().fromArgument(field.type(), a[0]));
      return null;
    }
    if (name.startsWith("set")) {
      FieldDefinition field = target(name.substring(3));
      write(field, browser.values().fromArgument(field.type(), a[0]));
      return null;
    }
    boolean count = name.startsWith("getNum") && a.length == 0 && isCount(name.substring(6));
    FieldDefinition field = source(name.substring(count ? 6 : 3));
    Object value = node.value(field.index());
    if (count) {
      return Values.size(field.type(), value);
    }
    if (a.length == 0) {
      return field.type() == FieldType.SFNode ? browser.wrap((Node) value) : value;
    }
    browser.values().toArgument(field.type(), value, a[0]);
    return null;
  }

  private boolean isCount(String x) {
    return find(x).map(field -> field.type().multiple()).orElse(false);
  }

  private Optional<FieldDefinition> find(String x) {
    String lower = Character.toLowerCase(x.charAt(0)) + x.substring(1);
    return node.type().field(lower).or(() -> node.type().field(lower + "_changed"));
  }

  private FieldDefinition source(String x) {
    return find(x)
        .orElseThrow(() -> new InvalidFieldException(node.type().name() + " has no field " + x));
  }

  private FieldDefinition target(String x) {
    String lower = Character.toLowerCase(x.charAt(0)) + x.substring(1);
    return node.type()
        .field(lower)
        .filter(this::writable)
        .or(() -> node.type().field("set_" + lower))
        .or(() -> node.type().field(lower))
        .orElseThrow(
            () -> new InvalidFieldException(node.type().name() + " has no field " + lower));
  }

  boolean writable(FieldDefinition field) {
    return field.access().acceptsEvents()
        || (field.access() == FieldAccess.INITIALIZE_ONLY && !realized);
  }

  /** Sends a value to a field, or gives an unrealized node its initial value. */
  void write(FieldDefinition field, @Nullable Object value) {
    if (!writable(field)) {
      String message =
          "%s of %s is %s".formatted(field.name(), node.type().name(), field.access().spelling());
      throw field.access() == FieldAccess.INITIALIZE_ONLY
          ? new InvalidOperationTimingException(message + " and the node is in use")
          : new InvalidWritableFieldException(message);
    }
    if (field.access() == FieldAccess.INITIALIZE_ONLY) {
      node.init(field.index(), value);
    } else {
      browser.write(node, field.index(), value);
    }
  }

  @Override
  public String toString() {
    return node.toString();
  }
}
