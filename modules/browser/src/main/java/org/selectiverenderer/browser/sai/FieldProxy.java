package org.selectiverenderer.browser.sai;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.scene.SafeListenerInvoker;
import org.selectiverenderer.browser.scene.SingleFieldListener;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.web3d.x3d.sai.InvalidReadableFieldException;
import org.web3d.x3d.sai.InvalidWritableFieldException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEvent;
import org.web3d.x3d.sai.X3DFieldEventListener;

/**
 * The dynamic proxy of a field behind the SAI interface of its type: SFInt32, MFString ... Two
 * objects of one field are equal. The node keeps an object only while it has listeners or user
 * data, and then returns the same one.
 */
final class FieldProxy implements InvocationHandler, SingleFieldListener, FieldMethods.Target {
  private static final Object[] NO_ARGUMENTS = {};
  private static final X3DFieldEventListener[] NONE = {};

  private final NodeProxy owner;
  private final EmbeddedFieldDefinition definition;
  private final X3DField proxy;

  /** Null, one listener, or an array of several listeners that is never modified. */
  private volatile @Nullable Object listeners;

  private volatile @Nullable Object userData;

  FieldProxy(NodeProxy owner, EmbeddedFieldDefinition definition) {
    this.owner = owner;
    this.definition = definition;
    proxy = owner.binding().types().proxy(definition.field().type(), this);
  }

  NodeProxy owner() {
    return owner;
  }

  X3DField proxy() {
    return proxy;
  }

  @Override
  public int field() {
    return definition.field().index();
  }

  @Override
  public @Nullable Object invoke(Object self, Method method, Object @Nullable [] arguments) {
    if (ProxyMaker.asksForHandler(method)) {
      return this;
    }
    Object[] a = arguments == null ? NO_ARGUMENTS : arguments;
    switch (method.getName()) {
      case "equals":
        return sameField(a[0]);
      case "hashCode":
        return 31 * owner.node().hashCode() + field();
      case "toString":
        return definition.field().toString();
      default:
        owner.check();
    }
    return switch (method.getName()) {
      case "getDefinition" -> definition;
      case "isReadable" -> readable();
      case "isWritable" -> owner.writable(definition.field());
      case "addX3DEventListener" -> {
        add((X3DFieldEventListener) a[0]);
        yield null;
      }
      case "removeX3DEventListener" -> {
        remove((X3DFieldEventListener) a[0]);
        yield null;
      }
      case "setUserData" -> {
        attach(a[0]);
        yield null;
      }
      case "getUserData" -> {
        FieldProxy kept = kept();
        yield kept == null ? null : kept.userData;
      }
      default ->
          FieldMethods.call(
              method.getName(), definition.field().type(), a, this, owner.binding().values());
    };
  }

  private boolean sameField(@Nullable Object other) {
    return other instanceof SaiObject object
        && object.handler() instanceof FieldProxy field
        && field.owner == owner
        && field.definition == definition;
  }

  private boolean readable() {
    return definition.field().access() != AccessType.INPUT_ONLY;
  }

  @Override
  public @Nullable Object value() {
    if (!readable()) {
      throw new InvalidReadableFieldException(
          "%s of %s is inputOnly and has no value".formatted(definition.getName(), owner));
    }
    return PrototypeInstance.value(owner.node(), field());
  }

  @Override
  public void change(UnaryOperator<@Nullable Object> change) {
    FieldDefinition field = definition.field();
    if (!owner.writable(field)) {
      throw new InvalidWritableFieldException(
          "%s of %s is %s%s"
              .formatted(
                  field.name(),
                  owner,
                  field.access().spelling(),
                  field.access() == AccessType.INITIALIZE_ONLY
                      ? " and the node is in use"
                      : " and takes no value"));
    }
    owner.change(field, change);
  }

  /** Returns the object of this field that the node keeps, if any. */
  private @Nullable FieldProxy kept() {
    return owner.kept(field());
  }

  private FieldProxy keep() {
    FieldProxy kept = kept();
    if (kept == null) {
      owner.node().addListener(field(), this);
      return this;
    }
    return kept;
  }

  private void dropIfUnused() {
    if (listeners == null && userData == null) {
      owner.node().removeListener(field(), this);
    }
  }

  private void attach(@Nullable Object data) {
    synchronized (owner.node()) {
      FieldProxy kept = data == null ? kept() : keep();
      if (kept != null) {
        kept.userData = data;
        kept.dropIfUnused();
      }
    }
  }

  private void add(X3DFieldEventListener listener) {
    synchronized (owner.node()) {
      FieldProxy kept = keep();
      X3DFieldEventListener[] before = kept.all();
      if (before.length == 0) {
        kept.listeners = listener;
      } else if (!Arrays.asList(before).contains(listener)) {
        X3DFieldEventListener[] after = Arrays.copyOf(before, before.length + 1);
        after[before.length] = listener;
        kept.listeners = after;
      }
    }
  }

  private void remove(X3DFieldEventListener listener) {
    synchronized (owner.node()) {
      FieldProxy kept = kept();
      if (kept != null) {
        kept.listeners = without(listener, kept.listeners);
        kept.dropIfUnused();
      }
    }
  }

  /** Returns listeners in the form of the field {@code listeners}, without one of them. */
  private static @Nullable Object without(
      X3DFieldEventListener listener, @Nullable Object listeners) {
    if (!(listeners instanceof X3DFieldEventListener[] several)) {
      return listener.equals(listeners) ? null : listeners;
    }
    X3DFieldEventListener[] after =
        Arrays.stream(several)
            .filter(other -> !other.equals(listener))
            .toArray(X3DFieldEventListener[]::new);
    return after.length > 1 ? after : after.length == 1 ? after[0] : null;
  }

  private X3DFieldEventListener[] all() {
    Object now = listeners;
    if (now == null) {
      return NONE;
    }
    return now instanceof X3DFieldEventListener[] several
        ? several
        : new X3DFieldEventListener[] {(X3DFieldEventListener) now};
  }

  /** Calls the listeners in order, except those that were removed meanwhile. */
  @Override
  public void fieldChanged(Node node, int index, @Nullable Object value, double time) {
    Object now = listeners;
    if (now == null || owner.gone()) {
      return;
    }
    X3DFieldEvent event = new X3DFieldEvent(proxy, time, userData);
    if (now instanceof X3DFieldEventListener[] several) {
      for (X3DFieldEventListener listener : several) {
        if (Arrays.asList(all()).contains(listener)) {
          call(listener, event, node);
        }
      }
    } else {
      call((X3DFieldEventListener) now, event, node);
    }
  }

  private void call(X3DFieldEventListener listener, X3DFieldEvent event, Node node) {
    SafeListenerInvoker.call(
        owner.binding().problems(),
        node.location(),
        () -> "a listener of " + definition.getName(),
        () -> listener.readableFieldChanged(event));
  }
}
