/** The words of the page, in English and Greek. */
export interface Words {
  readonly loading: (percent: number) => string;
  readonly failed: string;
  readonly condition: string;
  readonly conditions: Readonly<Record<'selective' | 'high' | 'high-low' | 'random', string>>;
  readonly viewpoint: string;
  readonly details: string;
  readonly fullScreen: string;
  readonly headset: string;
  readonly headsetFailed: string;
  readonly walk: string;
  readonly walkByTouch: string;
  readonly frames: (perSecond: number) => string;
  readonly areas: string;
  readonly none: string;
  readonly objects: string;
  readonly hidden: string;
}

const ENGLISH: Words = {
  loading: (percent) => (percent < 100 ? `Loading: ${percent} %` : 'The scene is being prepared.'),
  failed: 'The scene cannot be shown.',
  condition: 'Condition',
  conditions: {
    selective: 'Selective',
    high: 'All with all polygons',
    'high-low': 'Expected ones with few polygons',
    random: 'A random half with few polygons',
  },
  viewpoint: 'Go to',
  details: 'Details',
  fullScreen: 'Full screen',
  headset: 'Enter VR',
  headsetFailed: 'The headset does not show the scene. Put it on and try again.',
  walk: 'Walk: arrow keys or W, A, S, D, or hold a mouse button. Look around: drag.',
  walkByTouch: 'Walk: drag on the left half. Look around: drag on the right half.',
  frames: (perSecond) => `${perSecond} frames per second`,
  areas: 'In',
  none: 'no area',
  objects: 'Versions shown',
  hidden: 'none',
};

const GREEK: Words = {
  loading: (percent) => (percent < 100 ? `Φόρτωση: ${percent} %` : 'Η σκηνή ετοιμάζεται.'),
  failed: 'Η σκηνή δεν μπορεί να εμφανιστεί.',
  condition: 'Συνθήκη',
  conditions: {
    selective: 'Επιλεκτική',
    high: 'Όλα με όλα τα πολύγωνα',
    'high-low': 'Τα αναμενόμενα με λίγα πολύγωνα',
    random: 'Τα μισά, τυχαία, με λίγα πολύγωνα',
  },
  viewpoint: 'Μετάβαση',
  details: 'Λεπτομέρειες',
  fullScreen: 'Πλήρης οθόνη',
  headset: 'Είσοδος σε VR',
  headsetFailed: 'Η συσκευή δεν δείχνει τη σκηνή. Φορέστε την και δοκιμάστε ξανά.',
  walk: 'Βάδισμα: βέλη ή W, A, S, D, ή κρατημένο κουμπί του ποντικιού. Βλέμμα: σύρσιμο.',
  walkByTouch: 'Βάδισμα: σύρσιμο στο αριστερό μισό. Βλέμμα: σύρσιμο στο δεξί μισό.',
  frames: (perSecond) => `${perSecond} καρέ το δευτερόλεπτο`,
  areas: 'Μέσα σε',
  none: 'καμία περιοχή',
  objects: 'Εκδοχές που φαίνονται',
  hidden: 'καμία',
};

/** Returns the words of a language by its code, such as el or en-GB. */
export function words(language: string): Words {
  return language.toLowerCase().startsWith('el') ? GREEK : ENGLISH;
}
