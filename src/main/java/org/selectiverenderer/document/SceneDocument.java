package org.selectiverenderer.document;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentFault;
import org.selectiverenderer.x3d.source.ElementSource;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.EncodedText;
import org.selectiverenderer.x3d.source.Entities;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.source.StartTag;
import org.selectiverenderer.x3d.source.TextChange;
import org.selectiverenderer.x3d.source.WrittenAttribute;
import org.selectiverenderer.x3d.source.XmlFault;

/**
 * A scene open for editing. Whatever its bytes are, an unchanged document gives them back; a
 * changed one differs in what was changed only.
 *
 * <p>For one thread at a time; {@link #snapshot} is for others.
 */
public final class SceneDocument {
  private static final String TYPING = "Typing";

  private final String name;
  private final EncodedText encoding;
  private final boolean compressed;
  private final byte @Nullable [] original;
  private final TextBuffer buffer;
  private final ElementSource source = new Live();
  private final UndoHistory history = new UndoHistory(this::apply);
  private final List<DocumentListener> listeners = new CopyOnWriteArrayList<>();
  private @Nullable ElementTree tree;
  private @Nullable DocumentFault fault;
  private Entities entities = Entities.NONE;
  private long revision;

  /** The latest snapshot, which all who ask for one share as long as one of them has it. */
  private WeakReference<Snapshot> latest = new WeakReference<>(null);

  private SceneDocument(String name, EncodedText encoding, boolean compressed, byte[] bytes) {
    this.name = name;
    this.encoding = encoding;
    this.compressed = compressed;
    // Bytes that are made again from the characters need not be kept.
    this.original = compressed || !encoding.exact() ? bytes : null;
    this.buffer = new TextBuffer(encoding.characters());
    entities = Entities.of(buffer.characters());
    try {
      tree = encoding.elements(source);
    } catch (XmlFault e) {
      readAnew(); // as after an edit, so that the fault has the same place then
    }
  }

  /**
   * Opens a file's bytes, compressed or not. A text that is not well formed is opened all the same.
   *
   * @param name of the file, for messages
   * @throws IOException if there is no text in it: damaged compression, with one line that names it
   */
  public static SceneDocument of(String name, byte[] bytes) throws IOException {
    boolean compressed = Gzip.compressed(bytes);
    try {
      EncodedText text = EncodedText.of(compressed ? Gzip.unpacked(bytes) : bytes);
      return new SceneDocument(name, text, compressed, bytes);
    } catch (IOException e) {
      throw new IOException(name + ": " + e.getMessage(), e);
    }
  }

  /** The file's name as it was given. */
  public String name() {
    return name;
  }

  /** The characters as they are now; a view, valid until the next edit. */
  public CharSequence text() {
    return buffer.characters();
  }

  /** A part of the characters. */
  public String text(int from, int to) {
    return buffer.characters().subSequence(from, to).toString();
  }

  /** The text of an element. */
  public String text(DocumentElement element) {
    return text(element.start(), element.end());
  }

  /** Grows with every change, undone ones included. */
  public long revision() {
    return revision;
  }

  /** The elements; empty while the text is not well formed. */
  public Optional<ElementTree> tree() {
    return Optional.ofNullable(tree);
  }

  /** Where the text is not well formed; empty when it is. */
  public Optional<DocumentFault> fault() {
    return Optional.ofNullable(fault);
  }

  /** Why the document cannot be changed without harm: a sentence; empty when it can. */
  public Optional<String> locked() {
    return encoding.exact()
        ? Optional.empty()
        : Optional.of(
            encoding
                    .complaint()
                    .orElse("its " + encoding.encoding() + " cannot be written again as it is")
                + "; it can be viewed but not changed. Save it as UTF-8 with a text "
                + "editor first");
  }

  /** The entities that the document's own DOCTYPE declares. */
  public Entities entities() {
    return entities;
  }

  /** The attributes of an element. */
  public StartTag tag(DocumentElement element) {
    return element.tag();
  }

  /** An attribute's value, references replaced; empty when it is not given. */
  public Optional<String> attribute(DocumentElement element, String attribute) {
    return tag(element).attribute(attribute).map(WrittenAttribute::value);
  }

  /** The place of a character. */
  public Location location(int offset) {
    CharSequence text = buffer.characters();
    int line = buffer.lines().line(text, offset);
    int start = buffer.lines().start(text, line);
    return new Location(name, line, Character.codePointCount(text, start, offset) + 1);
  }

  /** The offset of a place; places beyond the end of a line are its end. */
  public int offset(int line, int column) {
    CharSequence text = buffer.characters();
    int at = buffer.lines().start(text, line);
    for (int i = 1; i < column && at < text.length() && text.charAt(at) >= ' '; i++) {
      at += Character.charCount(Character.codePointAt(text, at));
    }
    return at;
  }

  /** How to lay out what is added here, after the hand of the author. */
  public Layout layout() {
    return new Layout(buffer.characters());
  }

  /**
   * Makes an edit.
   *
   * @throws EditRefused if the document is locked
   */
  public void perform(Edit edit) {
    unlocked();
    history.perform(edit);
  }

  /**
   * Writes files and makes the edit that goes with them, as one step: undoing it concerns the files
   * too.
   *
   * @throws EditRefused if the document is locked; nothing is written then
   * @throws IOException if a file cannot be written, with one line that names it; nothing has
   *     changed then
   */
  public void perform(Edit edit, List<StepFile> files) throws IOException {
    unlocked();
    if (files.isEmpty()) {
      history.perform(edit);
    } else {
      history.perform(edit, StepFiles.write(files));
    }
  }

  /**
   * Replaces characters as by typing; what is typed in a row is one step.
   *
   * @throws EditRefused if the document is locked
   */
  public void type(int from, int to, String text) {
    unlocked();
    history.type(TYPING, new TextChange(from, to, text));
  }

  private void unlocked() {
    locked()
        .ifPresent(
            why -> {
              throw new EditRefused(name + ": " + why);
            });
  }

  /** The steps so far. */
  public UndoHistory history() {
    return history;
  }

  /** Whether there is something to save. */
  public boolean modified() {
    return history.modified();
  }

  /**
   * The text as it was then is in the file now. After changes meanwhile all is unsaved, whatever is
   * undone.
   */
  public void markSaved(Snapshot then) {
    if (then.revision() == revision) {
      history.markSaved();
    } else {
      history.markUnsaved();
    }
  }

  /** The text is in no file, such as one recovered after a crash. */
  public void markUnsaved() {
    history.markUnsaved();
  }

  /** The document as it is now. */
  public Snapshot snapshot() {
    Snapshot now = latest.get();
    if (now == null || now.revision() != revision) {
      String text = buffer.characters().toString();
      now = new Snapshot(name, revision, text, locked(), this::encoded);
      latest = new WeakReference<>(now);
    }
    return now;
  }

  private byte[] encoded(String text) {
    if (original != null && text.equals(encoding.characters())) {
      return original.clone(); // nothing has changed, or all is undone
    }
    byte[] plain = encoding.bytes(text);
    return compressed ? Gzip.packed(plain) : plain;
  }

  public void addListener(DocumentListener listener) {
    listeners.add(listener);
  }

  public void removeListener(DocumentListener listener) {
    listeners.remove(listener);
  }

  /** The text as it is now. */
  private final class Live implements ElementSource {
    private final FieldParser parser = new FieldParser();

    @Override
    public String file() {
      return name;
    }

    @Override
    public CharSequence characters() {
      return buffer.characters();
    }

    @Override
    public Location location(int offset) {
      return SceneDocument.this.location(offset);
    }

    @Override
    public FieldParser parser() {
      return parser;
    }

    @Override
    public Entities entities() {
      return entities;
    }
  }

  private List<TextChange> apply(List<TextChange> changes) {
    List<TextChange> inverse = buffer.apply(changes);
    revision++;
    boolean followed = tree != null && tree.follow(changes, revision);
    if (!followed) {
      readAnew();
    }
    DocumentListener.Change change = new DocumentListener.Change(revision, changes, !followed);
    listeners.forEach(listener -> listener.changed(change));
    return inverse;
  }

  private void readAnew() {
    if (tree != null) {
      tree.detach();
    }
    entities = Entities.of(buffer.characters());
    try {
      tree = ElementTree.of(source, revision);
      fault = null;
    } catch (XmlFault e) {
      tree = null;
      fault = e.fault();
    }
  }
}
