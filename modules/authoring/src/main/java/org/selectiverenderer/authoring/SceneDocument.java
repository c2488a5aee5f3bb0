package org.selectiverenderer.authoring;

import java.io.IOException;
import java.lang.ref.WeakReference;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.source.DecodedText;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.DocumentError;
import org.selectiverenderer.x3d.source.ElementSource;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.source.EntityTable;
import org.selectiverenderer.x3d.source.Gzip;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.StartTag;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.source.XmlParseException;

/**
 * A scene file opened for editing as text. An unchanged document is saved with exactly its original
 * bytes; a changed one differs only in the changed parts.
 *
 * <p>It is not thread-safe; other threads read a {@link #snapshot}.
 */
public final class SceneDocument {
  private static final String TYPING = "Typing";

  private final String name;
  private final DecodedText encoding;
  private final boolean compressed;
  private final byte @Nullable [] original;
  private final TextBuffer buffer;
  private final ElementSource source = new Live();
  private final UndoHistory history = new UndoHistory(this::apply);
  private final List<DocumentListener> listeners = new CopyOnWriteArrayList<>();
  private @Nullable ElementTree tree;
  private @Nullable DocumentError fault;

  /** The tree from before the text was broken; null while it is well-formed. */
  private @Nullable BrokenTree broken;

  private EntityTable entities = EntityTable.NONE;
  private long revision;

  /** The latest snapshot, which is shared as long as it is reachable. */
  private WeakReference<DocumentSnapshot> latest = new WeakReference<>(null);

  private SceneDocument(String name, DecodedText encoding, boolean compressed, byte[] bytes) {
    this.name = name;
    this.encoding = encoding;
    this.compressed = compressed;
    // The original bytes are kept only if they cannot be restored from the characters.
    this.original = compressed || !encoding.exact() ? bytes : null;
    this.buffer = new TextBuffer(encoding.characters());
    entities = EntityTable.of(buffer.characters());
    try {
      tree = encoding.elements(source);
    } catch (XmlParseException e) {
      readAnew(); // as after an edit, so that the fault has the same location
    }
  }

  /**
   * Opens the bytes of a file, compressed or not. A text that is not well-formed is opened
   * nevertheless.
   *
   * @param name name of the file, for messages
   * @throws IOException if the compressed data is damaged, with a one-line message that names the
   *     file
   */
  public static SceneDocument of(String name, byte[] bytes) throws IOException {
    boolean compressed = Gzip.compressed(bytes);
    try {
      DecodedText text = DecodedText.of(compressed ? Gzip.unpacked(bytes) : bytes);
      return new SceneDocument(name, text, compressed, bytes);
    } catch (IOException e) {
      throw new IOException(name + ": " + e.getMessage(), e);
    }
  }

  /** Returns the file's name as it was given. */
  public String name() {
    return name;
  }

  /** Returns a view of the present text, valid until the next edit. */
  public CharSequence text() {
    return buffer.characters();
  }

  /** Returns a part of the text. */
  public String text(int from, int to) {
    return buffer.characters().subSequence(from, to).toString();
  }

  /** Returns the text of an element. */
  public String text(DocumentElement element) {
    return text(element.start(), element.end());
  }

  /** Returns the revision number, which grows with every change, undoing included. */
  public long revision() {
    return revision;
  }

  /** Returns the element tree; empty while the text is not well-formed. */
  public Optional<ElementTree> tree() {
    return Optional.ofNullable(tree);
  }

  /** Returns the well-formedness error; empty if there is none. */
  public Optional<DocumentError> fault() {
    return Optional.ofNullable(fault);
  }

  /**
   * Returns the reason why the document is read-only, as a sentence; empty if it can be changed.
   */
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

  /** Returns the entities that the document's own DOCTYPE declares. */
  public EntityTable entities() {
    return entities;
  }

  /** The attributes of an element. */
  public StartTag tag(DocumentElement element) {
    return element.tag();
  }

  /** An attribute's value, references replaced; empty when it is not given. */
  public Optional<String> attribute(DocumentElement element, String attribute) {
    return tag(element).attribute(attribute).map(SourceAttribute::value);
  }

  /** Returns the location of a character. */
  public SourceLocation location(int offset) {
    CharSequence text = buffer.characters();
    int line = buffer.lines().line(text, offset);
    int start = buffer.lines().start(text, line);
    return new SourceLocation(name, line, Character.codePointCount(text, start, offset) + 1);
  }

  /** Returns the line of a character, from 1; however long the line is, in a moment. */
  public int line(int offset) {
    return buffer.lines().line(buffer.characters(), offset);
  }

  /** Returns the offset of a location; a column beyond the end of the line gives the line's end. */
  public int offset(int line, int column) {
    CharSequence text = buffer.characters();
    int at = buffer.lines().start(text, line);
    for (int i = 1; i < column && at < text.length() && text.charAt(at) >= ' '; i++) {
      at += Character.charCount(Character.codePointAt(text, at));
    }
    return at;
  }

  /** Returns the formatter that writes additions in the author's style. */
  public SourceFormatter layout() {
    return new SourceFormatter(buffer.characters());
  }

  /**
   * Performs an edit.
   *
   * @throws EditRejectedException if the document is locked
   */
  public void perform(Edit edit) {
    unlocked();
    history.perform(edit);
  }

  /**
   * Writes files and performs the edit that belongs to them as one undo step, which restores the
   * files too.
   *
   * @throws EditRejectedException if the document is locked; then nothing is written
   * @throws IOException if a file cannot be written, with a one-line message that names it; then
   *     nothing has changed
   */
  public void perform(Edit edit, List<UndoableFileWrite> files) throws IOException {
    unlocked();
    if (files.isEmpty()) {
      history.perform(edit);
    } else {
      history.perform(edit, UndoableFileWrites.write(files, () -> {}));
    }
  }

  /**
   * Performs an edit as one step together with files that have been written for it.
   *
   * @throws EditRejectedException if the document is locked; the files stay
   */
  public void perform(Edit edit, UndoableFileWrites written) {
    unlocked();
    history.perform(edit, written);
  }

  /**
   * Replaces characters as by typing; consecutive typing is one undo step.
   *
   * @throws EditRejectedException if the document is locked
   */
  public void type(int from, int to, String text) {
    unlocked();
    history.type(TYPING, new TextEdit(from, to, text));
  }

  private void unlocked() {
    locked()
        .ifPresent(
            why -> {
              throw new EditRejectedException(name + ": " + why);
            });
  }

  /** Returns the undo history. */
  public UndoHistory history() {
    return history;
  }

  /** Returns whether the document has unsaved changes. */
  public boolean modified() {
    return history.modified();
  }

  /**
   * Reports that a snapshot has been saved. If the document has changed since, it stays unsaved,
   * whatever is undone.
   */
  public void markSaved(DocumentSnapshot then) {
    if (then.revision() == revision) {
      history.markSaved();
    } else {
      history.markUnsaved();
    }
  }

  /** Marks the document as unsaved, for example after a recovery. */
  public void markUnsaved() {
    history.markUnsaved();
  }

  /** Returns a snapshot of the present state. */
  public DocumentSnapshot snapshot() {
    DocumentSnapshot now = latest.get();
    if (now == null || now.revision() != revision) {
      String text = buffer.characters().toString();
      now = new DocumentSnapshot(name, revision, text, locked(), this::encoded);
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

  /** Gives the element tree access to the present text. */
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
    public SourceLocation location(int offset) {
      return SceneDocument.this.location(offset);
    }

    @Override
    public FieldParser parser() {
      return parser;
    }

    @Override
    public EntityTable entities() {
      return entities;
    }
  }

  private List<TextEdit> apply(List<TextEdit> changes) {
    List<TextEdit> inverse = buffer.apply(changes);
    revision++;
    boolean followed = tree != null && tree.follow(changes, revision);
    if (!followed) {
      reread(changes);
    }
    DocumentListener.Change change = new DocumentListener.Change(revision, changes, !followed);
    listeners.forEach(listener -> listener.changed(change));
    return inverse;
  }

  /** Finds tree or fault of a text whose changes the tree does not follow. */
  private void reread(List<TextEdit> changes) {
    if (tree != null) {
      tree.detach();
      broken = new BrokenTree(tree);
    }
    if (broken == null) {
      readAnew();
      return;
    }
    boolean mended = broken.mended(changes, tree == null, buffer.characters(), revision);
    DocumentError found = mended ? null : broken.fault().orElse(null);
    if (mended || found != null) {
      tree = mended ? broken.tree() : null;
      fault = found;
    } else {
      readAnew();
    }
    if (tree != null) {
      broken = null;
    }
  }

  private void readAnew() {
    entities = EntityTable.of(buffer.characters());
    try {
      tree = ElementTree.of(source, revision);
      fault = null;
    } catch (XmlParseException e) {
      tree = null;
      fault = e.fault();
    }
  }
}
