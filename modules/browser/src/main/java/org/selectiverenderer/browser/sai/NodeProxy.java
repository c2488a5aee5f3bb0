package org.selectiverenderer.browser.sai;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;
import org.web3d.x3d.sai.InvalidFieldException;
import org.web3d.x3d.sai.InvalidNodeException;
import org.web3d.x3d.sai.InvalidOperationTimingException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DNode;

/**
 * The dynamic proxy of a node behind the SAI interface of its type; {@link NodeMethod} tells what
 * each method means. It has few fields, because a scene may have hundreds of thousands of nodes.
 */
final class NodeProxy implements InvocationHandler {
  private static final Object[] NO_ARGUMENTS = {};

  private final SaiContext binding;
  private final Node node;
  private final NodeTypeInfo kind;
  private final X3DNode proxy;
  private volatile boolean realized;
  private volatile boolean disposed;

  /**
   * @param realized whether the node is part of a scene: its initializeOnly fields are fixed
   */
  NodeProxy(SaiContext binding, Node node, boolean realized) {
    this.binding = binding;
    this.node = node;
    this.realized = realized;
    kind = binding.types().kind(node.type());
    proxy = kind.proxy(this);
  }

  SaiContext binding() {
    return binding;
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

  /** Returns whether the SAI object or its browser was disposed of. */
  boolean gone() {
    return disposed || binding.disposed();
  }

  /** Throws if the SAI object or its browser was disposed of. */
  void check() {
    binding.check();
    if (disposed) {
      throw new InvalidNodeException(node + " is disposed of");
    }
  }

  @Override
  public @Nullable Object invoke(Object self, Method method, Object @Nullable [] arguments) {
    if (ProxyMaker.asksForHandler(method)) {
      return this;
    }
    Object[] a = arguments == null ? NO_ARGUMENTS : arguments;
    NodeMethod meaning = kind.meaning(method);
    return switch (meaning.operation()) {
      case EQUALS -> self == a[0];
      case HASH_CODE -> System.identityHashCode(self);
      case TO_STRING -> node.toString();
      default -> {
        check();
        yield call(meaning, a);
      }
    };
  }

  private @Nullable Object call(NodeMethod meaning, Object[] a) {
    switch (meaning.operation()) {
      case NODE_NAME:
        return node.type().name();
      case NODE_TYPE:
        return kind.numbers();
      case DEFINITIONS:
        return kind.definitions();
      case FIELD:
        return field((String) a[0]);
      case REALIZE:
        realized = true;
        return null;
      case IS_REALIZED:
        return realized;
      case DISPOSE:
        dispose();
        return null;
      case WRITE:
        write(target(meaning), a[0]);
        return null;
      default:
        return read(meaning, a);
    }
  }

  /**
   * Disposes of the SAI object only: the node stays, and gets another object when it is asked for
   * again.
   */
  private void dispose() {
    disposed = true;
    synchronized (node) {
      node.companion(null);
      for (FieldDefinition field : node.type().fields()) {
        FieldProxy kept = kept(field.index());
        if (kept != null) {
          node.removeListener(field.index(), kept);
        }
      }
    }
  }

  /** Returns the field object that the node keeps for this proxy, if any. */
  @Nullable FieldProxy kept(int field) {
    return node.listener(field, FieldProxy.class, proxy -> proxy.owner() == this);
  }

  private X3DField field(String name) {
    EmbeddedFieldDefinition definition = kind.definition(name);
    FieldProxy known = kept(definition.field().index());
    return (known != null ? known : new FieldProxy(this, definition)).proxy();
  }

  private @Nullable Object read(NodeMethod meaning, Object[] a) {
    FieldDefinition field = meaning.field();
    if (field == null) {
      throw new InvalidFieldException(node.type().name() + " has no field " + meaning.name());
    }
    Object value = PrototypeInstance.value(node, field.index());
    return switch (meaning.operation()) {
      case COUNT -> SaiValueConverter.size(field.type(), value);
      case READ -> field.type() == FieldType.SFNode ? binding.wrap((Node) value) : value;
      default -> {
        binding.values().toArgument(field.type(), value, a[0]);
        yield null;
      }
    };
  }

  private FieldDefinition target(NodeMethod meaning) {
    if (meaning.field() != null && writable(meaning.field())) {
      return meaning.field();
    }
    if (meaning.input() != null) {
      return meaning.input();
    }
    if (meaning.field() == null) {
      throw new InvalidFieldException(node.type().name() + " has no field " + meaning.name());
    }
    throw new InvalidOperationTimingException(
        "%s of %s is %s and the node is in use"
            .formatted(meaning.name(), node, meaning.field().access().spelling()));
  }

  boolean writable(FieldDefinition field) {
    return field.access().acceptsEvents()
        || (field.access() == AccessType.INITIALIZE_ONLY && !realized);
  }

  private void write(FieldDefinition field, @Nullable Object argument) {
    Object value = binding.values().fromArgument(field.type(), argument);
    change(field, old -> value);
  }

  /**
   * Sends a new value to a writable field. A node that is not realized yet belongs to the
   * application alone: it takes the value at once and sends no event.
   */
  void change(FieldDefinition field, UnaryOperator<@Nullable Object> change) {
    if (!realized && field.access() != AccessType.INPUT_ONLY) {
      node.init(field.index(), changed(field, change));
    } else {
      binding.execute(() -> binding.sendNow(node, field.index(), changed(field, change)));
    }
  }

  private @Nullable Object changed(FieldDefinition field, UnaryOperator<@Nullable Object> change) {
    return SaiValueConverter.accepted(
        field, change.apply(PrototypeInstance.value(node, field.index())));
  }

  @Override
  public String toString() {
    return node.toString();
  }
}
