import { createBrindle } from './brindle/slim.js';
import { serve } from './brindle/serve.js';

serve(self, createBrindle);
