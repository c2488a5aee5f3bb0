package org.selectiverenderer.browser.script;

import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.ScriptRuntime;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.script.value.FieldValue;
import org.selectiverenderer.browser.script.value.FieldValueConverter;
import org.selectiverenderer.browser.script.value.NodeAccess;
import org.selectiverenderer.browser.script.value.ValueOwner;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.field.FieldType;

/** The nodes of the scene as one script reads and writes them: what it may write, and when. */
final class ScriptNodeAccess implements NodeAccess {
  private final ScriptNode node;
  private final ScriptFieldValues own;
  private final FieldValueConverter values;
  private final Consumer<String> remarks;
  private final PendingWrites writes = new PendingWrites();
  private final Set<Node> made = Collections.newSetFromMap(new WeakHashMap<>());
  private boolean undirected;
  private boolean late;

  /**
   * @param own the fields of the Script itself
   * @param remarks receives what is said of the script, to go on after its name
   */
  ScriptNodeAccess(
      ScriptNode node,
      ScriptFieldValues own,
      FieldValueConverter values,
      Consumer<String> remarks) {
    this.node = node;
    this.own = own;
    this.values = values;
    this.remarks = remarks;
  }

  /**
   * Registers a node that the script has made: the script may also set its initializeOnly fields.
   */
  Node own(Node created) {
    made.add(created);
    return created;
  }

  @Override
  public Node seen(Node other) {
    return PrototypeInstance.seen(other, node.within());
  }

  private boolean isOwn(Node of, FieldDefinition field) {
    return of == node && field.index() >= node.type().ownFrom();
  }

  @Override
  public @Nullable Object read(Node of, FieldDefinition field, FieldDefinition input) {
    boolean ofScript = isOwn(of, field);
    if (ofScript && field.access().sendsEvents()) {
      return own.get(field);
    }
    FieldValue known = writes.object(of, input);
    if (known != null && !ofScript) {
      return known;
    }
    Object value =
        ofScript ? values.toField(field.type(), own.get(field)) : writes.read(of, field, input);
    Object shown = values.toScript(field.type(), value, new InField(of, input));
    if (shown instanceof FieldValue object) {
      writes.object(of, input, object);
    }
    return shown;
  }

  @Override
  public void write(Node to, FieldDefinition field, @Nullable Object value) {
    if (isOwn(to, field) && field.access().sendsEvents()) {
      own.set(field, values.toScript(field.type(), value, null));
      return;
    }
    checkWritable(to, field);
    accept(field, value);
    remark(to, field);
    writes.add(to, field, value);
    if (field.access() == AccessType.INITIALIZE_ONLY && made.contains(to)) {
      PrototypeInstance.replace(to, field.index(), value);
    }
  }

  /** Throws for fields that scripts cannot write. */
  private static void checkWritable(Node to, FieldDefinition field) {
    boolean fixed = field.access() == AccessType.INITIALIZE_ONLY && !(to instanceof ScriptNode);
    if (!field.access().acceptsEvents() && !fixed) {
      throw ScriptRuntime.typeError(
          "%s of %s is %s and cannot be set"
              .formatted(field.name(), to.type(), field.access().spelling()));
    }
  }

  /** Throws for nodes of types that a field does not accept. */
  private static void accept(FieldDefinition field, @Nullable Object value) {
    if (value instanceof Node one) {
      accept(field, one);
    } else if (field.type() == FieldType.MFNode && value instanceof Iterable<?> nodes) {
      nodes.forEach(one -> accept(field, (Node) one));
    }
  }

  private static void accept(FieldDefinition field, Node value) {
    if (!field.nodeTypes().isEmpty() && field.nodeTypes().stream().noneMatch(value.type()::is)) {
      throw ScriptRuntime.typeError(
          "%s takes %s, not a %s"
              .formatted(
                  field.name(), String.join(" or ", field.nodeTypes()), value.type().name()));
    }
  }

  /**
   * Reports once that an initializeOnly field is written after initialisation (X3D 4.0, 4.4.2.2),
   * and once that a script writes to nodes without directOutput (X3D 4.0, 29.2.6).
   */
  private void remark(Node to, FieldDefinition field) {
    boolean fixed = field.access() == AccessType.INITIALIZE_ONLY;
    if ((fixed ? late : undirected) || made.contains(to)) {
      return;
    }
    if (fixed) {
      late = true;
      remarks.accept(
          "writes to %s of %s, which is initializeOnly; other browsers may refuse that"
              .formatted(field.name(), to.type().name()));
    } else if (!node.bool("directOutput")) {
      undirected = true;
      remarks.accept("writes to nodes without directOutput true; other browsers may refuse that");
    }
  }

  /**
   * Gives the nodes that the script has made what it has written to their initializeOnly fields so
   * far, before they are written as text or shown.
   */
  void complete() {
    writes.replace(made::contains);
  }

  /** Returns what the function has written to nodes, to send it with {@link #send}. */
  List<PendingWrites.Sent> take() {
    return writes.take();
  }

  /** Sends what was taken. */
  static void send(List<PendingWrites.Sent> taken, EventCascade cascade) {
    PendingWrites.send(taken, cascade);
  }

  /** Drops what was written. */
  void clear() {
    writes.clear();
  }

  /** The field that an object belongs to, also after the call in which the script got it. */
  private final class InField implements ValueOwner {
    private final Node of;
    private final FieldDefinition field;

    InField(Node of, FieldDefinition field) {
      this.of = of;
      this.field = field;
    }

    @Override
    public void beforeChange() {
      checkWritable(of, field);
    }

    @Override
    public void beforeElement(@Nullable Object element) {
      accept(field, element);
    }

    @Override
    public void changed(FieldValue value) {
      remark(of, field);
      writes.add(of, field, value);
    }
  }
}
