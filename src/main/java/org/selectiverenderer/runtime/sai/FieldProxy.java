package org.selectiverenderer.runtime.sai;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.runtime.scene.FieldListener;
import org.selectiverenderer.runtime.scene.Node;
import org.selectiverenderer.x3d.FieldAccess;
import org.selectiverenderer.x3d.FieldDefinition;
import org.selectiverenderer.x3d.FieldType;
import org.web3d.x3d.sai.InvalidReadableFieldException;
import org.web3d.x3d.sai.MField;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEvent;
import org.web3d.x3d.sai.X3DFieldEventListener;

/** A field behind the interface of its type: SFInt32, MFString ... */
final class FieldProxy implements InvocationHandler {
  private final EmbeddedBrowser browser;
  private final NodeProxy owner;
  private final FieldDefinition definition;
  private final X3DField proxy;
  private @Nullable Object userData;

  FieldProxy(EmbeddedBrowser browser, NodeProxy owner, FieldDefinition definition) {
    this.browser = browser;
    this.owner = owner;
    this.definition = definition;
    proxy =
        (X3DField)
            Proxy.newProxyInstance(
                X3DField.class.getClassLoader(),
                new Class<?>[] {interfaceOf(definition.type())},
                this);
  }

  X3DField proxy() {
    return proxy;
  }

  private Class<?> interfaceOf(FieldType type) {
    return browser
        .types()
        .find(type.name())
        .orElse(type.multiple() ? MField.class : X3DField.class);
  }

  @Override
  public @Nullable Object invoke(Object self, Method method, Object @Nullable [] arguments) {
    Object[] a = arguments == null ? new Object[0] : arguments;
    return switch (method.getName()) {
      case "equals" -> self == a[0];
      case "hashCode" -> System.identityHashCode(self);
      case "toString" -> definition.toString();
      case "getDefinition" -> new EmbeddedFieldDefinition(definition);
      case "isReadable" -> readable();
      case "isWritable" -> owner.writable(definition);
      case "addX3DEventListener" -> {
        if (definition.access().sendsEvents()) {
          owner.node().addListener(definition.index(), adapt(a[0]));
        }
        yield null;
      }
      case "removeX3DEventListener" -> {
        owner.node().removeListener(definition.index(), adapt(a[0]));
        yield null;
      }
      case "setUserData" -> {
        userData = a[0];
        yield null;
      }
      case "getUserData" -> userData;
      default -> access(method.getName(), a);
    };
  }

  private @Nullable Object access(String method, Object[] a) {
    FieldType type = definition.type();
    Values values = browser.values();
    return switch (method) {
      case "getSize" -> Values.size(type, value());
      case "getValue" -> {
        if (a.length == 0) {
          yield type.isNode() ? browser.wrap((Node) value()) : value();
        }
        values.toArgument(type, value(), a[0]);
        yield null;
      }
      case "get1Value" -> {
        if (a.length == 1) {
          yield values.element(type, value(), (Integer) a[0]);
        }
        values.element(type, value(), (Integer) a[0], a[1]);
        yield null;
      }
      case "setValue" ->
          type == FieldType.SFImage
              ? write(ImageValues.of((Integer) a[0], (Integer) a[1], (Integer) a[2], (int[]) a[3]))
              : write(
                  a.length == 1
                      ? values.fromArgument(type, a[0])
                      : values.first(type, (Integer) a[0], a[1]));
      case "append" -> write(values.splice(type, value(), Values.size(type, value()), 0, a[0]));
      case "clear" -> write(type.zero());
      case "insertValue" -> write(values.splice(type, value(), (Integer) a[0], 0, a[1]));
      case "removeValue" -> write(values.splice(type, value(), (Integer) a[0], 1, null));
      case "set1Value" -> write(values.splice(type, value(), (Integer) a[0], 1, a[1]));
      default -> ImageValues.call(method, a, (int[]) value(), this::write);
    };
  }

  private boolean readable() {
    return definition.access() != FieldAccess.INPUT_ONLY;
  }

  private @Nullable Object value() {
    if (!readable()) {
      throw new InvalidReadableFieldException(
          "%s of %s is inputOnly and has no value".formatted(definition.name(), owner));
    }
    return owner.node().value(definition.index());
  }

  private @Nullable Object write(@Nullable Object value) {
    owner.write(definition, value);
    return null;
  }

  private FieldListener adapt(Object listener) {
    return new Adapter(this, (X3DFieldEventListener) listener);
  }

  /** Equal for the same listener of the same field, so that it can be removed. */
  private static final class Adapter implements FieldListener {
    private final FieldProxy field;
    private final X3DFieldEventListener listener;

    Adapter(FieldProxy field, X3DFieldEventListener listener) {
      this.field = field;
      this.listener = listener;
    }

    @Override
    public void fieldChanged(Node node, int index, @Nullable Object value, double time) {
      listener.readableFieldChanged(new X3DFieldEvent(field.proxy, time, field.userData));
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Adapter adapter
          && adapter.field == field
          && adapter.listener == listener;
    }

    @Override
    public int hashCode() {
      return Objects.hash(System.identityHashCode(field), System.identityHashCode(listener));
    }
  }
}
