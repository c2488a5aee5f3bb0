package example;

import java.lang.reflect.Array;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.web3d.x3d.sai.MFNode;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldDefinition;
import org.web3d.x3d.sai.X3DFieldEvent;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.X3DFieldTypes;
import org.web3d.x3d.sai.X3DNode;

/** A node of any type: its fields by name, and who listens to them. */
final class TinyNode {
  private final Class<? extends X3DNode> type;
  private final Map<String, Object> values = new LinkedHashMap<>();
  private final Map<String, List<X3DFieldEventListener>> listeners = new LinkedHashMap<>();
  private final X3DNode node;

  /** A node with fields: a name, its value, another name ... */
  TinyNode(Class<? extends X3DNode> type, Object... fields) {
    this.type = type;
    for (int i = 0; i < fields.length; i += 2) {
      values.put((String) fields[i], fields[i + 1]);
      listeners.put((String) fields[i], new ArrayList<>());
    }
    node = standIn(type, this::call);
  }

  /** The node as programs see it. */
  X3DNode asNode() {
    return node;
  }

  /** Gives a field another value, and tells those who listen to it. */
  void set(String field, Object value, double time) {
    values.put(field, value);
    X3DFieldEvent event = new X3DFieldEvent(node, time, null);
    List.copyOf(listeners.get(field)).forEach(listener -> listener.readableFieldChanged(event));
  }

  private Object call(Method method, Object[] arguments) {
    String name = method.getName();
    return switch (name) {
      case "getNodeName" -> type.getSimpleName();
      case "getFieldDefinitions" ->
          values.keySet().stream().map(this::definition).toArray(X3DFieldDefinition[]::new);
      case "getField" -> field((String) arguments[0]);
      case "getValue" -> copied("value", arguments[0]);
      default -> {
        if (name.startsWith("getNum")) {
          String plural = fieldName(name.substring("getNum".length()));
          yield Array.getLength(values.get(plural));
        }
        String field = fieldName(name.substring("get".length()));
        if (name.startsWith("set")) {
          set(field, arguments[0], 0);
          yield null;
        }
        yield values.get(field);
      }
    };
  }

  private static String fieldName(String capitalised) {
    return Character.toLowerCase(capitalised.charAt(0)) + capitalised.substring(1);
  }

  private Object copied(String field, Object target) {
    Object array = values.get(field);
    System.arraycopy(array, 0, target, 0, Array.getLength(array));
    return null;
  }

  private X3DFieldDefinition definition(String field) {
    boolean nodes = values.get(field) instanceof X3DNode[];
    return standIn(
        X3DFieldDefinition.class,
        (method, arguments) ->
            switch (method.getName()) {
              case "getName" -> field;
              case "getAccessType" -> X3DFieldTypes.INPUT_OUTPUT;
              case "getFieldType" -> nodes ? X3DFieldTypes.MFNODE : X3DFieldTypes.SFSTRING;
              default -> throw new UnsupportedOperationException(method.getName());
            });
  }

  private X3DField field(String name) {
    boolean nodes = values.get(name) instanceof X3DNode[];
    return standIn(
        nodes ? MFNode.class : X3DField.class,
        (method, arguments) ->
            switch (method.getName()) {
              case "getDefinition" -> definition(name);
              case "getSize" -> Array.getLength(values.get(name));
              case "getValue" -> copied(name, arguments[0]);
              case "addX3DEventListener" ->
                  listeners
                      .computeIfAbsent(name, unknown -> new ArrayList<>())
                      .add((X3DFieldEventListener) arguments[0]);
              case "removeX3DEventListener" -> listeners.get(name).remove(arguments[0]);
              default -> throw new UnsupportedOperationException(method.getName());
            });
  }

  private interface Behaviour {
    Object call(Method method, Object[] arguments);
  }

  /** An object of an interface; two are equal if they are the same. */
  private static <T> T standIn(Class<? extends T> type, Behaviour behaviour) {
    return type.cast(
        Proxy.newProxyInstance(
            TinyNode.class.getClassLoader(),
            new Class<?>[] {type},
            (proxy, method, arguments) ->
                switch (method.getName()) {
                  case "equals" -> proxy == arguments[0];
                  case "hashCode" -> System.identityHashCode(proxy);
                  case "toString" -> type.getSimpleName();
                  default -> {
                    Object answer = behaviour.call(method, arguments);
                    yield method.getReturnType() == void.class ? null : answer;
                  }
                }));
  }
}
